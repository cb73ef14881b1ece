# make demo   install, and run the main job on simulated data
# make test   install what the tests need, and run them all
# make lint   the checks of style, types and imports alone
# make blender  Blender's extension, a zip in dist
# make docs   the documentation as a site, in out/site
# make bench  install what the benchmarks need, run them, and write docs/benchmarks.md (EFFORT=quick, normal or full)
# make before  the first version and today's in one run, in turn; writes docs/before.md
# make fuzz   damaged files for everything that reads, MINUTES=1 long; writes docs/fuzzing.md
# make test-lowest  the lowest versions that pyproject.toml allows, in an environment of their own, and the tests that touch each of them
# make dist   the wheel and the source archive in dist, byte for byte the same from the same commit
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

LOWEST ?= .venv-lowest
# What each package is used for, in minutes: numbers and kernels, pictures, tables, maps and clusters, meshes, rendering, exports.
LOWEST_TESTS := $(patsubst %,tests/test_%.py,models equations fitting_solver graph_tracing kernels_loops material images files_spreadsheet \
	measurements_tables measurements_readers maps_making maps_cluster meshes_files rendering_scenes rendering_plugins exports_materialx exports_usd \
	certification_glsl soiling gltf cli)

.PHONY: demo test test-lowest lint blender docs bench before fuzz dist clean
.DELETE_ON_ERROR:

demo: $(VENV)/.installed-all
	$(BIN)/motes demo -o out/demo

# Lint runs beside the tests, which run also where it complains, and say their result last.  A test that fails runs once more, so that a
# browser or a killed process that was late on a busy machine is no failure; the summary names each such test (RERUN).
test: $(VENV)/.installed-dev
	@command -v chromium google-chrome > /dev/null && command -v node > /dev/null && test -d viewer/node_modules \
	  || echo "without chromium, node or viewer/node_modules (npm ci) the viewer's tests in a browser are skipped, by name"
	@log=$$(mktemp); { $(MAKE) --no-print-directory lint > $$log 2>&1; } & lint=$$!; \
	$(BIN)/python -m pytest -n $(JOBS) --dist worksteal --reruns 1 -rR; tests=$$?; \
	wait $$lint; lint=$$?; \
	test $$lint -eq 0 || { cat $$log; echo "lint failed, see above"; }; rm -f $$log; \
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

# uv resolves to the lowest versions of what pyproject.toml names; pip cannot.  Warnings of old packages are not ours.
test-lowest: $(LOWEST)/.installed
	$(LOWEST)/bin/python -m pytest -n $(JOBS) --dist worksteal --reruns 1 -rR -W default $(LOWEST_TESTS)

$(LOWEST)/.installed: pyproject.toml
	@test -n "$(PYTHON)" || { echo "Motes needs Python 3.11 or later; name one: make PYTHON=/path/to/python3.11"; exit 1; }
	@$(PYTHON) -m venv $(LOWEST)
	@$(LOWEST)/bin/python -m pip install --quiet --disable-pip-version-check uv
	@$(LOWEST)/bin/uv pip install --quiet --python $(LOWEST)/bin/python --resolution lowest-direct --editable '.[all,test]'
	@touch $@

# Archives hold times; that of the commit makes them the same whenever and wherever they are built.
dist: $(VENV)/.installed-dev
	rm -rf dist
	SOURCE_DATE_EPOCH=$$(git log -1 --format=%ct) $(BIN)/python -m build --no-isolation --outdir dist

blender: $(VENV)/.installed-all
	$(BIN)/python tools/blender_build.py -o dist

docs: $(VENV)/.installed-docs
	$(BIN)/python tools/site_build.py

bench: $(VENV)/.installed-dev
	$(BIN)/python benchmarks/run.py --effort $(EFFORT)

before: $(VENV)/.installed-dev
	$(BIN)/python benchmarks/before.py

fuzz: $(VENV)/.installed-dev
	$(BIN)/python tools/fuzz.py --minutes $(MINUTES) --output docs/fuzzing.md

clean:
	rm -rf $(VENV) $(LOWEST) .bpy out build dist .mypy_cache .ruff_cache .pytest_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
