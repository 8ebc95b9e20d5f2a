# The commands of Precess. `make` alone lists them.

CARGO ?= cargo
PRECESS = target/release/precess
OUT = out

# Cargo's own variable, where it is set.
CARGO_TARGET_DIR ?= target
WASM = wasm32-unknown-unknown

.PHONY: help run test lint docs golden wasm wasm-target test-web test-web-now clean cargo

help:
	@echo "make run    simulate a top, three magnets and three planets; pictures and tables go to $(OUT)/"
	@echo "make test   every test, the lints, the documentation"
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

test: cargo lint
	$(CARGO) test --workspace
	@$(MAKE) --no-print-directory test-web

lint: cargo
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --workspace --no-deps --quiet

golden: cargo
	PRECESS_BLESS=1 $(CARGO) test -p precess --test golden

# Two builds of the same core, with and without lanes of 128 bits. Never relaxed SIMD: its results differ between
# machines. A folder for each, so that neither build makes the other one stale; no path of this machine in the file.
wasm: wasm-target
	@mkdir -p web/wasm
	@$(call build-wasm,precess,)
	@$(call build-wasm,precess-simd128,-C target-feature=+simd128)

build-wasm = CARGO_TARGET_$(shell echo $(WASM) | tr a-z- A-Z_)_RUSTFLAGS="$(2) --remap-path-prefix=$${CARGO_HOME:-$$HOME/.cargo}=cargo" \
	$(CARGO) build --quiet --profile wasm -p precess-wasm --target $(WASM) --target-dir $(CARGO_TARGET_DIR)/$(1) \
	&& cp $(CARGO_TARGET_DIR)/$(1)/$(WASM)/wasm/precess_wasm.wasm web/wasm/$(1).wasm

wasm-target: cargo
	@test -d "$$(rustc --print target-libdir --target $(WASM))" || rustup target add $(WASM)

# Whoever lacks a tool for this face still gets the rest of the tests; the gate sets PRECESS_REQUIRE_ALL=1.
test-web:
	@if ! node -e 'process.exit(Number(process.versions.node.split(".")[0] < 20))' 2>/dev/null || ! npm -v >/dev/null 2>&1; \
	then lacks="Node.js 20 or later with npm (https://nodejs.org)"; \
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

web/node_modules/.package-lock.json: web/package-lock.json
	cd web && npm ci --no-audit --no-fund && touch node_modules/.package-lock.json

clean:
	$(CARGO) clean
	rm -rf $(OUT)
