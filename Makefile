# The commands of Precess. `make` alone lists them.

CARGO ?= cargo
PRECESS = target/release/precess
OUT = out

.PHONY: help run test lint docs golden clean cargo

help:
	@echo "make run    simulate a top, three magnets and three planets; pictures and tables go to $(OUT)/"
	@echo "make test   every test, the lints, the documentation"
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

lint: cargo
	$(CARGO) fmt --all --check
	$(CARGO) clippy --workspace --all-targets -- -D warnings
	RUSTDOCFLAGS="-D warnings" $(CARGO) doc --workspace --no-deps --quiet

golden: cargo
	PRECESS_BLESS=1 $(CARGO) test -p precess --test golden

clean:
	$(CARGO) clean
	rm -rf $(OUT)
