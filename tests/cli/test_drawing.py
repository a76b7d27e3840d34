from __future__ import annotations

from pathlib import Path

import pytest

from footfall.cli import main


def test_it_draws_into_a_folder_that_it_makes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    folder = tmp_path / "new" / "figures"
    assert main(["figures", "-o", str(folder), "--no-animations"]) == 0
    names = sorted(path.name for path in folder.iterdir())
    assert names[0] == "README.md"
    assert [name[:9] for name in names[1:]] == [f"figure_{number:02d}" for number in range(2, 19)]
    told = capsys.readouterr().out.splitlines()
    assert str(folder / "figure_04_relation.svg") in told
    assert "  25 cells, 9 of them Err." in told
    assert told[-1] == str(folder / "README.md")


def test_a_file_is_no_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "taken").write_text("")
    assert main(["figures", "-o", str(tmp_path / "taken")]) == 2
    assert capsys.readouterr().err == (
        f"footfall: {tmp_path / 'taken'}: it is a file; name a folder\n"
    )


def test_a_folder_without_motions_leaves_nothing_behind(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "motions").mkdir()
    output = tmp_path / "figures"
    assert main(["figures", "-o", str(output), "--motions", str(tmp_path / "motions")]) == 2
    assert "holds no motion of a biped that plays a part" in capsys.readouterr().err
    assert not output.exists()
