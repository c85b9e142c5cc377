# make app: set up and open the workbench.  make test: set up and run the tests.  make bench: measure speed.
# make verify: the long tests.  make coverage: lines that no unit test runs.
# make docs: the documents as HTML, docs/_build/html.
# make lock: after a change of requirements*.txt.  make audit: known vulnerabilities.
PYTHON ?= python3
# Who can reach the workbench of `make app`: localhost is this machine only, 0.0.0.0 everybody who can reach it.
ADDRESS ?= localhost
PORT ?= 8501
BIN = .venv/bin
# Node comes into .venv with pip; npm and what it starts look for it on the path.
NPM = PATH="$(CURDIR)/$(BIN):$$PATH" $(BIN)/npm

# By the lock: these packages and no others, each file by its hash.
INSTALL = $(BIN)/python -m pip install --quiet --require-hashes --no-deps

.PHONY: app test unit browser lint lint-python lint-js coverage verify bench docs lock audit clean

app: .venv/.app
	@echo "The workbench: http://$(ADDRESS):$(PORT) (a browser opens as soon as it is ready; Ctrl-C ends it)"
	@$(BIN)/streamlit run app/main.py --server.address $(ADDRESS) --server.port $(PORT) \
	  --logger.hideWelcomeMessage true --logger.level warning

# Side by side: a browser test often waits, and unit tests use that time.
test: lint
	@echo "Unit tests and browser tests run side by side; each prints its report when it has ended."
	$(MAKE) --no-print-directory --jobs 2 --output-sync=target unit browser

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

# Lines and branches that no unit test runs, file by file. The tests take longer while they are measured.
coverage: .venv/.dev
	$(BIN)/python -m pytest --ignore=tests/browser -n 2 --dist worksteal --cov --cov-report=term-missing:skip-covered

# The long tests: random views against an independent judge, detectors against ground truth, the lens on 1,000 views;
# neural inverses and a designed grid on random worlds; searches of several workers and of a cluster, and on PostgreSQL
# where the distribution's package is installed (apt-get install postgresql).
verify: .venv/.verify
	$(BIN)/python -m bench.hold
	$(BIN)/python -m laplace_core report verdicts --jobs 2 --check
	$(BIN)/python -m laplace_core report detectors --check
	$(BIN)/python -m laplace_core report neural --check
	$(BIN)/python -m laplace_core report grids --horizon 50 --check
	$(BIN)/python -m laplace_core report grids --horizon 200 --noise 0.01 --check
	$(BIN)/python -m laplace_core report inverse-certificates --check
	$(BIN)/python -m laplace_core report inverse-consistency --jobs 2 --check
	$(BIN)/python -m laplace_core report inverse-bumps --check
	$(BIN)/python -m laplace_core report inverse-feasible --check
	$(BIN)/python -m laplace_core report inverse-agents --check
	$(BIN)/python -m pytest -m long
	LENS_VIEWS=1000 $(BIN)/python -m pytest tests/test_js.py

bench: .venv/.bench
	OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 $(BIN)/python -m bench

# A warning is an error. Then what the documents show is run, as in `make test`.
docs: .venv/.docs
	$(BIN)/python -m sphinx -q -W --keep-going -E -b html docs docs/_build/html
	$(BIN)/python -m pytest tests/test_documents.py tests/test_architecture.py
	@echo "The documents: docs/_build/html/index.html"

lock: .venv/.lock
	$(BIN)/python .ci/lock.py

audit: .venv/.lock
	$(BIN)/python .ci/audit.py

clean:
	rm -rf .venv node_modules docs/_api docs/_build

# torch without CUDA is small and enough; where pip finds no such build, the one with CUDA is taken.
.venv/.app: requirements.lock requirements-cpu.lock requirements-cuda.lock pyproject.toml
	$(PYTHON) -m venv .venv
	$(INSTALL) -r requirements.lock
	$(INSTALL) -r requirements-cpu.lock || $(INSTALL) -r requirements-cuda.lock
	$(BIN)/python -m pip install --quiet --no-deps --no-build-isolation --editable .
	touch $@

.venv/.bench: .venv/.dev requirements-bench.txt
	$(BIN)/python -m pip install --quiet -r requirements-bench.txt
	touch $@

.venv/.verify: .venv/.dev requirements-verify.txt
	$(BIN)/python -m pip install --quiet -r requirements-verify.txt
	touch $@

.venv/.docs: .venv/.dev requirements-docs.txt
	$(BIN)/python -m pip install --quiet -r requirements-docs.txt
	touch $@

.venv/.lock: .venv/.app requirements-lock.txt
	$(BIN)/python -m pip install --quiet -r requirements-lock.txt
	touch $@

.venv/.dev: .venv/.app requirements-dev.lock package-lock.json
	$(INSTALL) -r requirements-dev.lock
	$(NPM) ci --silent --no-audit --no-fund
	touch $@
