# The commands of Precess. `make` alone lists them.

CARGO ?= cargo
OUT = out

# Cargo's own variable, where it is set.
CARGO_TARGET_DIR ?= target
PRECESS = $(CARGO_TARGET_DIR)/release/precess
WASM = wasm32-unknown-unknown

.PHONY: help run lab bench test lint docs golden soak wasm wasm-target node test-web test-web-now bench-web test-python
.PHONY: test-python-now wheel bench-python test-arm clean cargo

help:
	@echo "make lab    build the lab and serve it to a browser on this machine"
	@echo "make run    simulate a top, three magnets and three planets; pictures and tables go to $(OUT)/"
	@echo "make bench  measure this program beside others, ratios first (BENCH=--long: for numbers to write down)"
	@echo "make bench-web  the same in WebAssembly beside native code, under Node and in Chromium"
	@echo "make bench-python  the Python package beside SciPy, heyoka, diffrax and pynamicalsys"
	@echo "make test   every test, the lints, the documentation"
	@echo "make soak   ten minutes of anything in the lab, where make test does one"
	@echo "make wasm   the core for a browser, in web/wasm/"
	@echo "make golden compute the golden hashes anew (only after a change of numbers that is meant)"

cargo:
	@command -v $(CARGO) >/dev/null 2>&1 || { echo "precess: Rust is missing: see https://rustup.rs" >&2; exit 1; }

$(PRECESS): cargo
	@$(CARGO) build --release --quiet -p precess-cli

run: $(PRECESS)
	@mkdir -p $(OUT)
	@for name in cone three-magnets three-planets; do \
	  echo "== $$name"; \
	  $(PRECESS) run scenarios/$$name.toml -o $(OUT)/$$name.csv --plot $(OUT)/$$name.svg || exit 1; \
	  $(PRECESS) run scenarios/$$name.toml --quiet --plot $(OUT)/$$name.png || exit 1; \
	done
	@echo "Pictures and tables are in $(OUT)/"

# The peers that this machine has; the others are skipped and say why.
BENCH =
BENCH_PYTHON = $(firstword $(wildcard benches/peers/venv/bin/python) python3)
PEERS = target/peers/exercise_7_5
HEYOKA = $(BENCH_PYTHON) -B benches/peers/heyoka_magnets.py --form

bench: $(PRECESS)
	@set --; \
	if command -v gcc >/dev/null 2>&1 && $(MAKE) --no-print-directory --silent -C benches/peers; then \
	  set -- "$$@" --peer c=$(PEERS)_native --peer c-strict=$(PEERS)_strict --peer c-fast=$(PEERS)_fast; \
	else echo "precess: the C programs are skipped, since they need gcc" >&2; fi; \
	for module in numba heyoka; do \
	  if ! $(BENCH_PYTHON) -B -c "import $$module" 2>/dev/null; then \
	    echo "precess: $$module is skipped, since $(BENCH_PYTHON) does not have it (see benches/peers/README.md)" >&2; \
	  elif test $$module = numba; then set -- "$$@" --peer "numba=$(BENCH_PYTHON) -B benches/peers/numba_magnets.py"; \
	  else for form in plain shared warm; do set -- "$$@" --peer "heyoka-$$form=$(HEYOKA) $$form"; done; fi; \
	done; \
	$(PRECESS) bench $(BENCH) "$$@"
	@if $(BENCH_PYTHON) -B -c "import heyoka" 2>/dev/null; then \
	  $(BENCH_PYTHON) -B benches/magnets/heyoka_basins.py $(PRECESS); \
	else echo "precess: basins beside heyoka are skipped, since $(BENCH_PYTHON) does not have it" >&2; fi
	@if $(BENCH_PYTHON) -B -c "import numpy" 2>/dev/null; then \
	  $(BENCH_PYTHON) -B benches/bodies/three_bodies.py $(PRECESS); \
	else echo "precess: three bodies are skipped, since $(BENCH_PYTHON) does not have numpy" >&2; fi
	@if $(BENCH_PYTHON) -B -c "import rebound" 2>/dev/null; then \
	  $(BENCH_PYTHON) -B benches/bodies/rebound_cluster.py $(PRECESS); \
	else echo "precess: rings of asteroids are skipped, since $(BENCH_PYTHON) does not have rebound" >&2; fi
	@$(BENCH_PYTHON) -B benches/tops/cone_peers.py $(PRECESS)
	@if $(BENCH_PYTHON) -B -c "import mujoco" 2>/dev/null; then \
	  $(BENCH_PYTHON) -B benches/tops/mujoco_tops.py $(PRECESS); \
	else echo "precess: mujoco is skipped, since $(BENCH_PYTHON) does not have it (see benches/peers/README.md)" >&2; fi
	@if $(PYTHON_WORKS); then $(MAKE) --no-print-directory bench-python; \
	else echo "precess: the Python package is skipped, since it needs $(PYTHON_NEEDS)" >&2; fi

# Node first: whoever lacks it need not wait for the rest to be built.
lab: cargo node wasm web/node_modules/.package-lock.json
	@$(MAKE) --no-print-directory web/dist/index.html
	@$(CARGO) build --release --quiet -p precess-cli
	@$(PRECESS) lab $(if $(PORT),--port $(PORT))

# Whatever in web/ is not made by a tool; the core in web/wasm/ is made, but the lab is made from it.
LAB_SOURCES = $(shell find web \( -name node_modules -o -name dist -o -name tests -o -name '*-results' \
	-o -name '*-report' \) -prune -o -type f -print)

web/dist/index.html: $(LAB_SOURCES) web/node_modules/.package-lock.json
	cd web && npm run --silent build

# Status 0 where Node is recent enough and npm is there.
NODE_WORKS = node -e 'const [a, b] = process.versions.node.split(".").map(Number); \
	process.exit(a > 20 || (a === 20 && b >= 19) ? 0 : 1)' 2>/dev/null && npm -v >/dev/null 2>&1
NODE = Node.js 20.19 or later with npm (https://nodejs.org)

node:
	@$(NODE_WORKS) || { echo "precess: the lab is built with $(NODE), which is missing" >&2; exit 1; }

test: cargo lint
	$(CARGO) test --workspace
	@$(MAKE) --no-print-directory test-web
	@$(MAKE) --no-print-directory test-python
	@$(MAKE) --no-print-directory test-arm

lint: cargo
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --workspace --no-deps --quiet

golden: cargo
	PRECESS_BLESS=1 $(CARGO) test -p precess --test golden --test basins

# Builds of the same core, with and without lanes of 128 bits, and one that holds the lab's first page alone. Never relaxed SIMD: its results differ between
# machines. A folder for each, so that neither build makes the other one stale; no path of this machine in the file.
# A file that did not change is left alone, so that the lab is not built anew from it.
wasm: wasm-target
	@mkdir -p web/wasm
	@$(call build-wasm,precess,,wasm)
	@$(call build-wasm,precess-simd128,-C target-feature=+simd128,wasm)
	@$(call build-wasm,precess-first,,wasm-first,--features first)

build-wasm = CARGO_TARGET_$(shell echo $(WASM) | tr a-z- A-Z_)_RUSTFLAGS="$(2) --remap-path-prefix=$${CARGO_HOME:-$$HOME/.cargo}=cargo" \
	$(CARGO) build --quiet --profile $(3) -p precess-wasm $(4) --target $(WASM) --target-dir $(CARGO_TARGET_DIR)/$(1) \
	&& { cmp -s $(CARGO_TARGET_DIR)/$(1)/$(WASM)/$(3)/precess_wasm.wasm web/wasm/$(1).wasm \
	|| cp $(CARGO_TARGET_DIR)/$(1)/$(WASM)/$(3)/precess_wasm.wasm web/wasm/$(1).wasm; }

wasm-target: cargo
	@test -d "$$(rustc --print target-libdir --target $(WASM))" || rustup target add $(WASM) || \
	{ echo "precess: Rust's target $(WASM) is missing: see https://rustup.rs" >&2; exit 1; }

# Whoever lacks a tool for this face still gets the rest of the tests; the gate sets PRECESS_REQUIRE_ALL=1.
test-web:
	@if ! { $(NODE_WORKS); }; \
	then lacks="$(NODE)"; \
	elif ! $(MAKE) --no-print-directory wasm-target; \
	then lacks="Rust's target $(WASM) (rustup target add $(WASM))"; \
	fi; \
	if [ -n "$$lacks" ]; then \
	  echo "precess: the tests of the core in the browser are skipped, since they need $$lacks" >&2; \
	  test "$$PRECESS_REQUIRE_ALL" != 1; exit; \
	fi; \
	$(MAKE) --no-print-directory test-web-now

test-web-now: wasm web/node_modules/.package-lock.json
	cd web && npm run --silent check && npm run --silent test && npm run --silent build -- --logLevel warn
	@if test -x "$(CHROMIUM)"; then cd web && CHROMIUM="$(CHROMIUM)" npm run --silent e2e; else \
	  echo "precess: the tests of the lab in a browser are skipped, since they need Chromium (Debian: chromium)" >&2; \
	  test "$$PRECESS_REQUIRE_ALL" != 1; fi

# Ten minutes of anything in the lab; `make test` does one.
soak: wasm web/node_modules/.package-lock.json
	cd web && npm run --silent build -- --logLevel warn
	cd web && PRECESS_SOAK=600 CHROMIUM="$(CHROMIUM)" npm run --silent e2e -- e2e/soak.spec.ts

# The browser of the tests.
CHROMIUM ?= $(or $(shell command -v chromium || command -v chromium-browser || command -v google-chrome),/usr/bin/chromium)

web/node_modules/.package-lock.json: web/package-lock.json
	cd web && npm ci --no-audit --no-fund && touch node_modules/.package-lock.json

# The Python package, built as a wheel and installed into an environment of its own, then tested there.
PYTHON ?= python3
VENV = $(abspath $(CARGO_TARGET_DIR))/python-venv

PYTHON_WORKS = $(PYTHON) -c 'import sys, ensurepip, venv; sys.exit(sys.version_info < (3, 10))' 2>/dev/null
PYTHON_NEEDS = Python 3.10 or later with venv (Debian: python3-venv)

test-python:
	@if ! $(PYTHON_WORKS); then \
	  echo "precess: the tests of the Python package are skipped, since they need $(PYTHON_NEEDS)" >&2; \
	  test "$$PRECESS_REQUIRE_ALL" != 1; exit; \
	fi; \
	$(MAKE) --no-print-directory test-python-now

# The wheel is built once: it goes into an environment with NumPy alone, as `pip install .` gives it, and into that of the tests.
WHEELS = $(abspath $(CARGO_TARGET_DIR))/python-wheel
BARE = $(abspath $(CARGO_TARGET_DIR))/python-bare

test-python-now: cargo $(VENV)/installed
	$(VENV)/bin/ruff format --check --quiet && $(VENV)/bin/ruff check --quiet
	@$(MAKE) --no-print-directory wheel
	$(VENV)/bin/mypy --cache-dir $(VENV)/mypy
	$(PYTHON) -m venv --clear $(BARE)
	$(BARE)/bin/pip install --quiet --disable-pip-version-check $(WHEELS)/precess-*-cp310-abi3-*.whl
	cd $(BARE) && bin/python -I $(abspath python/tests/bare.py)
	$(VENV)/bin/python -m pytest -p no:cacheprovider

wheel: cargo $(VENV)/installed
	@rm -rf $(WHEELS)
	PATH="$(VENV)/bin:$$PATH" $(VENV)/bin/pip wheel --quiet --no-build-isolation --no-deps --wheel-dir $(WHEELS) .
	@$(VENV)/bin/pip install --quiet --no-deps --force-reinstall $(WHEELS)/precess-*.whl

# The cone beside SciPy, what an import costs, and the way to a first basin map beside the peers that this machine has.
bench-python: wheel
	@$(VENV)/bin/python -B benches/python/cone.py
	@$(VENV)/bin/python -B benches/python/maps.py $(BENCH_PYTHON)

$(VENV)/installed: python/requirements.txt
	$(PYTHON) -m venv --clear $(VENV)
	$(VENV)/bin/pip install --quiet --disable-pip-version-check -r python/requirements.txt
	@touch $@

# Exercise 7.5 in Node and Chromium beside the same work done natively, in rounds of POINTS x POINTS starts.
ROUNDS = 7
POINTS = 32
bench-web: wasm web/node_modules/.package-lock.json
	@$(CARGO) build --release --quiet -p precess-wasm --example exercise_7_5
	@native=$$(realpath $(CARGO_TARGET_DIR))/release/examples/exercise_7_5 && \
	cd web && node bench/bench.js "$$native" $(ROUNDS) $(POINTS)

# The same bits on 64-bit ARM, with and without NEON: built by a cross compiler, run by an emulator, with a tenth of the
# golden steps.
ARM = aarch64-unknown-linux-gnu
ARM_ENV = CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_LINKER=aarch64-linux-gnu-gcc \
	CARGO_TARGET_AARCH64_UNKNOWN_LINUX_GNU_RUNNER="qemu-aarch64 -L /usr/aarch64-linux-gnu" PRECESS_GOLDEN=short

test-arm: cargo
	@if ! command -v aarch64-linux-gnu-gcc >/dev/null || ! command -v qemu-aarch64 >/dev/null; \
	then lacks="a cross compiler and an emulator (Debian: gcc-aarch64-linux-gnu, libc6-dev-arm64-cross, qemu-user)"; \
	elif ! { test -d "$$(rustc --print target-libdir --target $(ARM))" || rustup target add $(ARM); }; \
	then lacks="Rust's target $(ARM) (rustup target add $(ARM))"; \
	fi; \
	if [ -n "$$lacks" ]; then \
	  echo "precess: the tests on ARM are skipped, since they need $$lacks" >&2; \
	  test "$$PRECESS_REQUIRE_ALL" != 1; exit; \
	fi; \
	$(ARM_ENV) $(CARGO) test --quiet --target $(ARM) -p precess-scalar --test golden_bits --test batch && \
	$(ARM_ENV) $(CARGO) test --quiet --target $(ARM) -p precess --test golden

clean:
	$(CARGO) clean
	rm -rf $(OUT)
