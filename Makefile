# Each target does all the set-up it needs in .venv, once.
PYTHON ?= python3
VENV := .venv
STAMP := $(VENV)/.installed
DOCS_STAMP := $(VENV)/.installed-docs

.PHONY: jump test check docs

jump: $(STAMP)  ## one jump: numbers, figures, film
	$(VENV)/bin/python run.py sim=jump contact=logbarrier

test: $(STAMP)  ## all tests that take less than a minute, compiling included
	$(VENV)/bin/python -m pytest -n 2 --dist loadgroup -m "not slow and not compiles and not processes"

check: $(STAMP)  ## style, types, import layers
	$(VENV)/bin/ruff check .
	$(VENV)/bin/ruff format --check .
	$(VENV)/bin/mypy
	$(VENV)/bin/lint-imports

docs: $(DOCS_STAMP)  ## the site, in site/, tutorial run and included
	NO_MKDOCS_2_WARNING=1 $(VENV)/bin/mkdocs build --strict

$(STAMP): pyproject.toml
	test -x $(VENV)/bin/python || $(PYTHON) -m venv $(VENV)
	$(VENV)/bin/python -m pip install --quiet --disable-pip-version-check -e '.[dev]'
	touch $@

$(DOCS_STAMP): $(STAMP)
	$(VENV)/bin/python -m pip install --quiet --disable-pip-version-check -e '.[docs]'
	touch $@
