PYTHON ?= python3
PORT ?= 8080
VENV := .venv
BIN := $(VENV)/bin
TSC := $(BIN)/node node_modules/typescript/bin/tsc
INSTALL := $(BIN)/python -m pip install --quiet --disable-pip-version-check --constraint constraints.txt

.PHONY: demo test browser check api-types safety drills soak worlds bench clean

$(VENV)/.installed: pyproject.toml constraints.txt
	@echo "Installing into $(VENV), once; this takes a minute or two ..."
	@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	@$(INSTALL) --editable .
	@touch $@

$(VENV)/.installed-test: $(VENV)/.installed
	@$(INSTALL) --editable '.[test]'
	@touch $@

node_modules/.installed: package.json package-lock.json $(VENV)/.installed-test
	@$(BIN)/npm ci --ignore-scripts --silent
	@touch $@

demo: $(VENV)/.installed
	@exec $(BIN)/bodydrive demo --port $(PORT)

# Files run side by side: first what computes, then what waits for real processes and judges them by the clock.
# What draws in 3D while a chair drives comes last, and has the machine for itself.
SIDE_BY_SIDE := --dist loadfile --no-loadscope-reorder

test: $(VENV)/.installed-test check
	$(BIN)/python -m pytest -n 2 $(SIDE_BY_SIDE) -m "not long and not real_time and not in_3d"
	$(BIN)/python -m pytest -n 2 $(SIDE_BY_SIDE) -m "not long and real_time and not in_3d"
	$(BIN)/python -m pytest -m "not long and in_3d"

browser: $(VENV)/.installed-test
	$(BIN)/python -m pytest -m long

check: $(VENV)/.installed-test node_modules/.installed
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(TSC)
	$(TSC) --project tsconfig.worker.json

api-types: node_modules/.installed
	PYTHONPATH=.:tests $(BIN)/python tests/api_types.py

safety: $(VENV)/.installed-test
	@$(INSTALL) --editable '.[safety]'
	$(BIN)/python tests/mutation.py

drills: $(VENV)/.installed-test
	PYTHONPATH=tests $(BIN)/python -m drills --jobs 2 --out docs/drills.md

soak: $(VENV)/.installed-test
	PYTHONPATH=tests $(BIN)/python -m soak --out docs/viewers.md

worlds: $(VENV)/.installed-test
	$(BIN)/python -m pytest tests/worlds/each_task.py

bench: $(VENV)/.installed-test
	$(BIN)/python -m bench $(PART)

clean:
	rm -rf $(VENV) node_modules dist build
