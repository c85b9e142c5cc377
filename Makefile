# make app: set up and open the workbench.  make test: set up and pass the tests.  make bench: ratios in one run.
# make verify: what takes long.  make coverage: what no unit test comes by.
PYTHON ?= python3
PORT ?= 8501
BIN = .venv/bin
# Node comes into .venv with pip; npm and what it starts look for it on the path.
NPM = PATH="$(CURDIR)/$(BIN):$$PATH" $(BIN)/npm

.PHONY: app test unit browser lint lint-python lint-js coverage verify bench clean

app: .venv/.app
	$(BIN)/streamlit run app/main.py --server.port $(PORT)

test: lint unit browser

unit: .venv/.dev
	$(BIN)/python -m pytest --ignore=tests/browser -n 2 --dist worksteal

browser: .venv/.dev
	$(BIN)/python -m pytest tests/browser -n 2 --dist loadfile -rs

lint: .venv/.dev
	$(MAKE) --no-print-directory --jobs 2 --output-sync=target lint-python lint-js

lint-python: .venv/.dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/lint-imports
	$(BIN)/mypy --num-workers 2 laplace_core app

lint-js: .venv/.dev
	$(NPM) run --silent lint

# Lines and branches that no unit test comes by, file by file. The tests take longer while they are watched.
coverage: .venv/.dev
	$(BIN)/python -m pytest --ignore=tests/browser -n 2 --dist worksteal --cov --cov-report=term-missing:skip-covered

# What takes long: random views against an independent judge, detectors against ground truth, the lens on 1,000 views.
verify: .venv/.dev
	$(BIN)/python -m laplace_core report verdicts --jobs 2 --check
	$(BIN)/python -m laplace_core report detectors --check
	$(BIN)/python -m laplace_core report inverse-certificates --check
	$(BIN)/python -m laplace_core report inverse-consistency --check
	$(BIN)/python -m laplace_core report inverse-bumps --check
	$(BIN)/python -m laplace_core report inverse-feasible --check
	$(BIN)/python -m pytest -m long
	LENS_VIEWS=1000 $(BIN)/python -m pytest tests/test_js.py

bench: .venv/.bench
	OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 $(BIN)/python -m bench

clean:
	rm -rf .venv node_modules

.venv/.app: requirements.txt pyproject.toml
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet -r requirements.txt
	$(BIN)/python -m pip install --quiet --no-deps --editable .
	touch $@

.venv/.bench: .venv/.dev requirements-bench.txt
	$(BIN)/python -m pip install --quiet -r requirements-bench.txt
	touch $@

.venv/.dev: .venv/.app requirements-dev.txt package-lock.json
	$(BIN)/python -m pip install --quiet -r requirements-dev.txt
	$(NPM) ci --silent --no-audit --no-fund
	touch $@
