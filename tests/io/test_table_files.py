from __future__ import annotations

import sys
from pathlib import Path

import pytest

from footfall.errors import FileFormatError, MissingExtraError
from footfall.io.table_files import read_csv, read_parquet, write_csv, write_parquet

COLUMNS = {"name": ["a", 'b "c", d'], "number": [0.1 + 0.2, -1e-300], "flag": [True, False]}


def test_a_csv_file_gives_its_cells_back(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    write_csv(COLUMNS, path)
    read = read_csv(path)
    assert read["name"] == COLUMNS["name"]
    assert [float(cell) for cell in read["number"]] == COLUMNS["number"]
    assert read["flag"] == ["true", "false"]


def test_a_parquet_file_gives_its_cells_back_and_always_the_same_bytes(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    write_parquet(COLUMNS, tmp_path / "one.parquet")
    write_parquet(COLUMNS, tmp_path / "other.parquet")
    assert read_parquet(tmp_path / "one.parquet") == COLUMNS
    assert (tmp_path / "one.parquet").read_bytes() == (tmp_path / "other.parquet").read_bytes()


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", ": is empty; its first line names the columns"),
        ("a,b\n1\n", ":2: has 1 cells, but the first line names 2 columns"),
        ("a,A\n1,2\n", ":1: names the column 'a' twice"),
        ('a\n"b\n', ": is no table of comma-separated values: unexpected end of data"),
    ],
)
def test_a_broken_csv_file_is_refused_in_one_line(tmp_path: Path, text: str, told: str) -> None:
    path = tmp_path / "table.csv"
    path.write_text(text)
    with pytest.raises(FileFormatError) as caught:
        read_csv(path)
    assert str(caught.value) == f"{path}{told}"


def test_blank_lines_and_spaces_about_names_do_no_harm(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("\nTime , Support\n\n0,R\n")
    assert read_csv(path) == {"time": ["0"], "support": ["R"]}


def test_a_broken_parquet_file_is_refused(tmp_path: Path) -> None:
    pytest.importorskip("pyarrow")
    path = tmp_path / "table.parquet"
    path.write_bytes(b"PAR1 no such thing PAR1")
    with pytest.raises(FileFormatError, match="is damaged or no Parquet file: "):
        read_parquet(path)


def test_a_parquet_file_that_unfolds_without_end_is_refused(tmp_path: Path) -> None:
    arrow = pytest.importorskip("pyarrow")
    parquet = pytest.importorskip("pyarrow.parquet")
    path = tmp_path / "bomb.parquet"
    parquet.write_table(arrow.table({"support": arrow.array(["R"]).take([0] * 3_000_000)}), path)
    with pytest.raises(FileFormatError) as caught:
        read_parquet(path)
    assert str(caught.value) == (
        f"{path}: unfolds to 3000000 rows of 1 columns, far more than such a file holds"
    )


def test_without_the_library_the_way_to_get_it_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", None)
    with pytest.raises(MissingExtraError) as caught:
        write_parquet(COLUMNS, tmp_path / "table.parquet")
    assert str(caught.value) == (
        "writing table.parquet needs pyarrow; pip install 'footfall[tables]'"
    )
    assert list(tmp_path.iterdir()) == []
