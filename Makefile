# `make demo` and `make test` are the two commands; each makes what it needs.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready

.PHONY: demo test lint full clean

$(READY): pyproject.toml constraints.txt
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[dev]'
	touch $(READY)

demo: $(READY)
	$(BIN)/footfall demo -o demo

lint: $(READY)
	$(BIN)/ruff check src tests
	$(BIN)/ruff format --check src tests
	$(BIN)/pyright

test: lint
	$(BIN)/pytest -q -n 2 -m "not full"

full: lint
	$(BIN)/pytest -q -n 2

clean:
	rm -rf $(VENV) demo out build dist
