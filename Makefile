# make demo   install, and run the main job on simulated data
# make test   install what the tests need, and run them all
# make lint   the checks of style, types and imports alone
# make blender  Blender's extension, a zip in dist
# make docs   the documentation as a site, in out/site
# make bench  install what the benchmarks need, run them, and write docs/benchmarks.md (EFFORT=quick, normal or full)
# make fuzz   damaged files for everything that reads, MINUTES=1 long; writes docs/fuzzing.md
# make clean  remove what these made

VENV ?= .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check
ifndef PYTHON
PYTHON := $(shell for p in python3 python3.14 python3.13 python3.12 python3.11; do \
	$$p -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && { echo $$p; break; }; done)
endif
JOBS ?= 2
EFFORT ?= normal
MINUTES ?= 1

.PHONY: demo test lint blender docs bench fuzz clean
.DELETE_ON_ERROR:

demo: $(VENV)/.installed-all
	$(BIN)/motes demo -o out/demo

# The tests run also where lint complains, and say their result last.  A test that fails runs once more, so that a
# browser or a killed process that was late on a busy machine is no failure; the summary names each such test (RERUN).
test: $(VENV)/.installed-dev
	@command -v chromium google-chrome > /dev/null && command -v node > /dev/null && test -d viewer/node_modules \
	  || echo "without chromium, node or viewer/node_modules (npm ci) the viewer's tests in a browser are skipped, by name"
	@$(MAKE) --no-print-directory lint; lint=$$?; \
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal --reruns 1 -rR; tests=$$?; \
	test $$lint -eq 0 || echo "lint failed, see above"; \
	exit $$((lint | tests))

lint: $(VENV)/.installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports --no-cache
	$(BIN)/python tools/rooms.py

# One rule for all sets of packages: all, dev and docs.  Making an environment over an existing one mends a half-made one.
$(VENV)/.installed-%: pyproject.toml
	@test -n "$(PYTHON)" || { echo "Motes needs Python 3.11 or later; python3 is $$(python3 --version 2>&1). Name one: make PYTHON=/path/to/python3.11"; exit 1; }
	@echo "installing motes[$*] into $(VENV) (the first time takes minutes)"
	@$(PYTHON) -m venv $(VENV)
	@$(PIP) --editable '.[$*]'
	@touch $@

blender: $(VENV)/.installed-all
	$(BIN)/python tools/blender_build.py -o dist

docs: $(VENV)/.installed-docs
	$(BIN)/python tools/site_build.py

bench: $(VENV)/.installed-dev
	$(BIN)/python benchmarks/run.py --effort $(EFFORT)

fuzz: $(VENV)/.installed-dev
	$(BIN)/python tools/fuzz.py --minutes $(MINUTES) --output docs/fuzzing.md

clean:
	rm -rf $(VENV) .bpy out build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
