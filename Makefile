# Each target does all the set-up it needs in .venv, once: with uv where that can be had, else with pip.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check
UV := $(BIN)/uv pip install --quiet --python $(BIN)/python
# The ordinary index has torch with 5.6 GB of CUDA.
TORCH := torch==2.13.0
TORCH_CPU := https://download.pytorch.org/whl/cpu
ANSWERS := $(BIN)/python -c "import urllib.request; urllib.request.urlopen('$(TORCH_CPU)/torch/', timeout=10)" 2>/dev/null

.PHONY: jump test check docs

jump: $(VENV)/.run  ## one jump: numbers, figures, film
	$(BIN)/snapjump sim=jump contact=logbarrier

test: $(VENV)/.dev  ## all tests that take less than a minute, compiling included
	$(BIN)/python -m pytest -n 2 --dist loadgroup -m "not slow and not compiles and not processes"

check: $(VENV)/.dev  ## style, types, import layers
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

docs: $(VENV)/.docs  ## the site, in site/, tutorial run and included
	NO_MKDOCS_2_WARNING=1 $(BIN)/mkdocs build --strict

$(VENV)/.python:
	$(PYTHON) -m venv $(VENV)
	$(PIP) uv || echo "no uv here: pip installs"
	touch $@

$(VENV)/.run: pyproject.toml | $(VENV)/.python
	$(UV) -e '.[run]' || $(PIP) -e '.[run]'
	touch $@

$(VENV)/.torch: | $(VENV)/.python
	$(ANSWERS) && $(UV) $(TORCH) --index-url $(TORCH_CPU) || $(PIP) $(TORCH)
	touch $@

$(VENV)/.dev: pyproject.toml | $(VENV)/.torch
	$(UV) -e '.[dev]' || $(PIP) -e '.[dev]'
	touch $@ $(VENV)/.run

$(VENV)/.docs: pyproject.toml | $(VENV)/.dev
	$(UV) -e '.[docs]' || $(PIP) -e '.[docs]'
	touch $@
