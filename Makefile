# make book: set up, derive, check, build the book.   make test: set up, lint, type-check, test.
# Needs Python 3.11 to 3.13 and make; everything else is installed into .venv from constraints.txt.
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
SHELL := /bin/sh
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
CHROMIUM ?= chromium
READY := $(VENV)/.ready

.PHONY: help book html draft pdf test derive check lint types bench times clean

help: ## show this list
	@grep -E '^[a-z]+:.*##' Makefile | sed 's/:.*## /\t/' | expand -t 10

# Compiled on all cores and without the packages' own tests; a package may hold a file that is no Python, as templates are.
$(READY): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; v = sys.version_info[:2]; sys.exit(None if (3, 11) <= v <= (3, 13) else "Python 3.11 to 3.13 is needed, this is %d.%d; name one with make PYTHON=..." % v)'
	@echo "Setting up $(VENV) (once, about a minute)"
	@$(PYTHON) -m venv --clear $(VENV)
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile -c constraints.txt setuptools
	@$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-compile --no-build-isolation \
		--config-settings editable_mode=compat -c constraints.txt -e '.[book,test]'
	@$(BIN)/python -W ignore -m compileall -qq -j 0 -x '/(tests|pip)/' $(VENV)/lib || true
	@touch $@

derive: $(READY) ## regenerate every emitted file from its derivation
	@$(BIN)/derivations write

check: $(READY) ## emitted files against the derivations; numbers against every other voice
	@$(BIN)/derivations check & derived=$$!; $(BIN)/granular check; compared=$$?; wait $$derived && exit $$compared

book: check html ## set up, derive, check and build the book

# Pages that were read without a warning are not read again; after a build that failed all are, so that it says so again.
html:
	@test -e book/_build/.without_warnings || rm -rf book/_build/.doctrees
	@rm -rf book/_build/html book/_build/granular.pdf book/_build/.without_warnings
	@$(BIN)/jupyter-book build book -n -W --keep-going -q
	@touch book/_build/.without_warnings
	@$(BIN)/python book/_ext/inspect_book.py book/_build/html
	@$(BIN)/python book/_ext/compare_builds.py book/_build/html
	@echo "The book is built. Open book/_build/html/index.html in a browser"

draft: $(READY) ## bring built pages up to date in seconds after an edit; those to publish come from make book
	@test -e book/_build/.without_warnings || rm -rf book/_build/.doctrees
	@rm -f book/_build/granular.pdf book/_build/.without_warnings
	@$(BIN)/jupyter-book build book -n -W --keep-going -q
	@touch book/_build/.without_warnings
	@$(BIN)/python book/_ext/inspect_book.py book/_build/html

# The pages are brought up to date first; from what was computed before, unless something changed.
pdf: $(READY) ## print the built book as one PDF; needs Chromium
	@$(BIN)/python book/_ext/pdf.py --browser '$(CHROMIUM)'
	@$(MAKE) --no-print-directory html
	@$(BIN)/python book/_ext/pdf.py book/_build/html book/_build/granular.pdf --browser '$(CHROMIUM)'
	@$(BIN)/python book/_ext/pdf_check.py book/_build/html book/_build/granular.pdf

lint: $(READY) ## style and strict types
	@$(BIN)/ruff check .
	@$(BIN)/mypy

# That emitted files are what the derivations give is one of the tests.
test: lint ## set up, lint, type-check, test
	@$(BIN)/python -m pytest -n logical --dist loadfile --no-loadscope-reorder

# The other packages are only needed here; where they cannot be had, their rows say so.
bench: $(READY) ## how fast it is beside the limit of the machine and other packages, under ten minutes
	@$(BIN)/python -c 'import elasticipy, rockphypy.GM' 2>/dev/null || \
		$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-build-isolation \
			--config-settings editable_mode=compat -c constraints.txt -e '.[peers]' || \
		echo "The other packages cannot be installed here: their comparisons are left out"
	@$(BIN)/granular speed --out book/_data/speed.json
	@$(BIN)/python -m pytest tests/benchmarks/test_routes.py -m benchmark -s -q

# Of the last commit, in another folder; run it on a machine that does nothing else.
times: $(READY) ## how long a cold build of the book takes, and every page of it
	@$(BIN)/python book/_ext/build_times.py book/_data/build_times.json

clean: ## remove everything that can be rebuilt
	@rm -rf $(VENV) build book/_build .pytest_cache .hypothesis .mypy_cache .ruff_cache *.egg-info
	@find . -name __pycache__ -type d -prune -exec rm -rf {} +
