# `make demo` and `make test` are the two commands; each makes what it needs.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready

.PHONY: demo test lint real full comparison coverage site clean

$(READY): pyproject.toml constraints.txt
	$(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[dev]'
	touch $(READY)

demo: $(READY)
	$(BIN)/footfall demo -o demo

lint: $(READY)
	$(BIN)/ruff check src tests benchmarks examples
	$(BIN)/ruff format --check src tests benchmarks examples
	$(BIN)/pyright

test: lint
	$(BIN)/pytest -q -n 2 -m "not full"

# What has been measured on real clips so far: supports, labels, cleaning, cycles.
real: $(READY)
	test -d ../shared/motions
	$(BIN)/pytest -q -s tests/real

full: lint
	$(BIN)/pytest -q -n 2

# docs/comparison.md, anew: ours beside what others offer. Without ../shared/motions, samples only.
comparison: $(READY)
	$(BIN)/python -m benchmarks.comparison

# Lines and branches of the core that its unit tests run, as plain Python. What plans thousands of
# slots is left out: uncompiled, each such test lasts minutes.
PLANNER := tests/sync/test_planner.py::test_
comma := ,
CORE := support sync timing blending adaptation skeleton motion detection
coverage: $(READY)
	NUMBA_DISABLE_JIT=1 $(BIN)/coverage run -m pytest -q -n 0 -p tests.plain_octets \
		-p tests.few_examples -m "not full" $(CORE:%=tests/%) \
		--deselect=$(PLANNER)at_every_phase --deselect=$(PLANNER)realistic_pairs \
		--deselect=tests/sync/test_gaits_of_four_legs.py \
		--deselect=tests/detection/test_contacts.py::test_six_seconds_at_sixty_frames
	$(BIN)/coverage report --include='$(subst $(eval ) ,$(comma),$(CORE:%=src/footfall/%/*))'

# The documentation as a site, in out/site.
site: $(READY)
	$(BIN)/zensical build -f mkdocs.yml

clean:
	rm -rf $(VENV) demo out build dist
