#!/usr/bin/env bash
# Builds, serves and tests the project from a machine that has rustup's cargo, node and npm.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'TXT'
usage: scripts/dev.sh COMMAND

  serve [VITE OPTIONS]  build the applet and serve it; edits in www/ show at once
  test                  every check and every test
  setup                 only install what the others need
  build                 only build: the wasm package (www/pkg) and the page (www/dist)
  package               build the npm package into dist/, and check what it exports and its types
  lint                  only rustfmt, clippy, rustdoc and tsc
  bench                 benchmarks; native against wasm; the page's bytes, first frame and drags

environment: CHROMIUM, CHROMEDRIVER  the browser and its driver, where they are not on the PATH
             FIREFOX                 Firefox, where it is not on the PATH
             WEBKIT_DRIVER, WEBKIT_BROWSER  WebKitGTK's WebKitWebDriver and its MiniBrowser
             XVFB                    the X server without a screen that these two are shown on
             SITE_URL                the address that the site will have, for links to its pages that other sites show
             SYNTHETICA_CACHE        where wasm tools and Python environments are kept (default ~/.cache/synthetica)
TXT
}

# With the minutes since the beginning, so that one sees where they went.
say() { printf '\n== %d:%02d %s\n' $((SECONDS / 60)) $((SECONDS % 60)) "$*"; }
fail() { printf 'dev.sh: %s\n' "$*" >&2; exit 1; }
has() { command -v "$1" >/dev/null 2>&1; }

# --- what is needed -------------------------------------------------------------------------------

setup_rust() {
  has cargo && has rustup || fail "needs rustup's cargo: see https://rustup.rs"
  # Adds the wasm target to the toolchain of rust-toolchain.toml, or installs that toolchain whole.
  local state
  state=$(rustup target list --installed 2>/dev/null; rustup component list --installed 2>/dev/null) || true
  if ! grep -qx wasm32-unknown-unknown <<<"$state" || ! grep -q ^clippy <<<"$state" || ! grep -q ^rustfmt <<<"$state"; then
    say "Rust toolchain of rust-toolchain.toml"
    rustup target add wasm32-unknown-unknown 2>/dev/null && rustup component add rustfmt clippy \
      || rustup toolchain install --no-self-update
  fi
}

cache() { printf %s "${SYNTHETICA_CACHE:-${XDG_CACHE_HOME:-$HOME/.cache}/synthetica}"; }

# wasm-pack and wasm-bindgen, built once for every clone with the same tools/ and toolchain.
setup_wasm_tools() {
  local key tool
  key=$(cat rust-toolchain.toml tools/Cargo.toml tools/Cargo.lock tools/src/bin/*.rs | git hash-object --stdin)
  local root; root=$(cache)/tools-${key:0:12}
  for tool in wasm-pack wasm-bindgen wasm-bindgen-test-runner; do
    if [ ! -x "$root/bin/$tool" ]; then
      say "wasm-pack and wasm-bindgen, into $root (about three minutes, once)"
      # Each builder has a folder of its own, so that two clones may start at once.
      cargo install --quiet --locked --path tools --root "$root" --target-dir "$root/build-$$"
      rm -r "$root/build-$$"
      break
    fi
  done
  export PATH=$root/bin:$PATH
}

setup_npm() {
  has node && has npm || fail "needs node (20.19 or later) and npm"
  if ! cmp -s tools/package-lock.json tools/node_modules/.installed-lock; then
    say "npm packages of tools/"
    npm ci --prefix tools --no-audit --no-fund
    cp tools/package-lock.json tools/node_modules/.installed-lock
  fi
  # www/ and tests/ find the packages by walking up to here.
  ln -sfn tools/node_modules node_modules
}

find_browser() {
  CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
  CHROMEDRIVER=${CHROMEDRIVER:-$(command -v chromedriver || true)}
  [ -x "$CHROMIUM" ] && [ -x "$CHROMEDRIVER" ]
}

setup_browser() {
  if ! find_browser && has apt-get && [ "$(id -u)" = 0 ]; then
    say "Chromium and its driver, by apt-get"
    { apt-get update -q && apt-get install -q -y --no-install-recommends chromium chromium-driver; } </dev/null
    find_browser || true
  fi
  [ -x "$CHROMIUM" ] || fail "needs Chromium or Chrome: install it, or give its path in CHROMIUM"
  [ -x "$CHROMEDRIVER" ] || fail "needs ChromeDriver of the browser's version: install it, or give its path in CHROMEDRIVER"
  export CHROMIUM CHROMEDRIVER
  # Tells wasm-bindgen's test runner which browser to start.
  export WASM_BINDGEN_TEST_WEBDRIVER_JSON=$PWD/tools/node_modules/.webdriver.json
  printf '{"goog:chromeOptions": {"binary": "%s"}}\n' "$CHROMIUM" >"$WASM_BINDGEN_TEST_WEBDRIVER_JSON"
}

# Firefox and WebKit, each with the X server without a screen: their tests say what is missing, and are skipped.
setup_engines() {
  if [ -n "$(missing_engines)" ] && has apt-get && [ "$(id -u)" = 0 ]; then
    say "Firefox and WebKit, by apt-get"
    { apt-get update -q && apt-get install -q -y --no-install-recommends firefox-esr webkit2gtk-driver xvfb libgl1-mesa-dri; } </dev/null || true
  fi
  local missing; missing=$(missing_engines)
  [ -z "$missing" ] || say "NOT TESTED, for want of programs: $missing"
}

missing_engines() { node tests/engines/start.mjs; }

# Python with what a file of requirements names, in an environment of its own, made once for every clone with the same
# requirements; PYTHON is its program.
setup_python() {
  local name=$1 wanted=$2 key
  if ! has python3 || ! python3 -c 'import venv, ensurepip' 2>/dev/null; then
    if has apt-get && [ "$(id -u)" = 0 ]; then
      say "Python, by apt-get"
      { apt-get update -q && apt-get install -q -y --no-install-recommends python3 python3-venv; } </dev/null
    fi
  fi
  python3 -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 11))' 2>/dev/null \
    || fail "needs python3 (3.11 or later) with its venv module, for $name"
  key=$({ cat "$wanted"; python3 -c 'import sys; print(sys.version, sys.executable)'; } | git hash-object --stdin)
  local root; root=$(cache)/$name-${key:0:12}
  if [ ! -d "$root" ]; then
    say "Python packages of $wanted, into $root"
    # Only a whole one gets its name, so that what was interrupted is made anew.
    python3 -m venv "$root-$$"
    "$root-$$/bin/python" -m pip install --quiet --disable-pip-version-check --only-binary :all: -r "$wanted"
    if [ -d "$root" ]; then rm -r "$root-$$"; else mv "$root-$$" "$root"; fi
  fi
  PYTHON=$root/bin/python
}

# What checks the exported models.
setup_mujoco() {
  setup_python mujoco tests/mujoco/requirements.txt
  MUJOCO_PYTHON=$PYTHON
}

# What builds the example pages: one lock file for all that comes from npm, and what writes pages in Python.
setup_examples() {
  local folder=examples/pages
  if ! cmp -s $folder/package-lock.json $folder/node_modules/.installed-lock; then
    say "npm packages of $folder"
    # The package itself is put in its place by the tests: it need not be built yet.
    npm ci --prefix $folder --no-audit --no-fund
    cp $folder/package-lock.json $folder/node_modules/.installed-lock
  fi
  setup_python examples tests/examples/requirements.txt
  export EXAMPLES_PYTHON=$PYTHON
}

# --- what is done ---------------------------------------------------------------------------------

# The whole package, and the one that the page loads first: with only what a page asks by itself, and without words for
# faults.
build_package() {
  build_wasm www/pkg
  build_wasm www/pkg-first --no-default-features
}

build_wasm() {
  local into=$1
  shift
  say "wasm package, into $into"
  # As a cdylib alone: of a crate that is a Rust library too, as `wasm-pack build` makes it, cargo does not optimise the
  # whole with the standard library, which is 5 kB more after gzip.
  local made=${CARGO_TARGET_DIR:-target}/wasm32-unknown-unknown/release/synthetica.wasm
  cargo rustc --release --locked --lib --crate-type cdylib --target wasm32-unknown-unknown "$@"
  wasm-bindgen --target web --out-dir "$into" "$made"
  # npm's binaryen, not wasm-pack's choice (see Cargo.toml), with what the compiler was let use. -Oz is no smaller
  # after gzip, and slower. Functions stay where they are even if only one other calls them: 3 kB less after gzip.
  # Nothing lives in the memory's first kilobyte: the linker puts the stack first, and that is its last one. So an added
  # constant may go into the load or store itself: 0.7 kB less after gzip, no slower.
  wasm-opt -O2 --converge --one-caller-inline-max-function-size=0 --low-memory-unused --optimize-added-constants-propagate \
    --enable-simd --enable-bulk-memory --enable-bulk-memory-opt --enable-nontrapping-float-to-int --enable-reference-types \
    --enable-sign-ext --enable-mutable-globals --enable-multivalue --strip-producers \
    "$into/synthetica_bg.wasm" -o "$into/optimised.wasm"
  mv "$into/optimised.wasm" "$into/synthetica_bg.wasm"
}

build_page() {
  say "page, into www/dist"
  vite build --config tools/vite.config.js
}

# The npm package: what publint and are-the-types-wrong find is an error. The wasm file has no types.
build_npm() {
  say "npm package, into dist"
  node tools/package/build.js
  publint --strict dist
  attw --pack dist --profile esm-only --exclude-entrypoints wasm --no-summary --format ascii
}

# The formatting, every lint and the documentation of both builds, no warning passes; and the crate's package.
lint_rust() {
  say "rustfmt"
  cargo fmt --check
  cargo fmt --check --manifest-path tools/Cargo.toml
  local target
  for target in "$(rustc -vV | sed -n 's/^host: //p')" wasm32-unknown-unknown; do
    say "clippy and rustdoc, $target"
    cargo clippy --locked --all-targets --all-features --target "$target" -- -D warnings
    RUSTDOCFLAGS="-D warnings" cargo doc --locked --no-deps --all-features --target "$target"
  done
  say "crate, as it would be published"
  cargo publish --dry-run --locked --allow-dirty
}

# The page's types, which include those of the built package.
lint_page() {
  say "tsc"
  tsc -p www
}

test_rust() {
  say "tests, native"
  cargo test --locked --all-features
}

# Each of the two runs skips the files that are meant for the other and still exits with 0: fail where nothing ran.
# (Examples in the documentation, which name their line, do not count.)
some_ran() {
  awk '{ print; fflush() } /^test .* ok$/ && !/\(line / { ran = 1 } END { exit !ran }' || fail "failed, or ran no test"
}

test_wasm() {
  # Seconds; the defaults (20 and 5) are short of a slow suite and a loaded machine.
  export WASM_BINDGEN_TEST_TIMEOUT=300 WASM_BINDGEN_TEST_DRIVER_TIMEOUT=60
  say "tests as WebAssembly, node"
  wasm-pack test --mode no-install --node . | some_ran
  say "tests as WebAssembly, Chromium"
  wasm-pack test --mode no-install --headless --chrome --chromedriver "$CHROMEDRIVER" . | some_ran
}

# Every sample as a MuJoCo model: MuJoCo's own residuals at every frame.
test_mujoco() {
  say "exported models, in MuJoCo"
  cargo build --quiet --locked --all-features --bin synthetica
  "$MUJOCO_PYTHON" tests/mujoco/check.py "${CARGO_TARGET_DIR:-target}/debug/synthetica" www/mechanisms
}

# The bytes that a visitor's browser loads for the planner; tests/e2e/budget.test.mjs keeps those of the page as a whole.
check_size() {
  local limit=110000 size # bytes after gzip
  # By node's zlib, as the benchmark prints it: gzip itself makes almost 1 % less of it, and servers differ.
  size=$(node -p "zlib.gzipSync(fs.readFileSync('www/pkg-first/synthetica_bg.wasm'), { level: 9 }).length")
  say "WebAssembly that is loaded first: $size bytes after gzip, at most $limit"
  [ "$size" -le "$limit" ]
}

test_page() {
  shopt -s failglob # a missing suite is an error
  say "page, units"
  node --test --test-reporter=spec tests/page/*.test.mjs
  say "package, in pages and programs of others"
  node --test --test-reporter=spec tests/package/*.test.mjs
  say "example pages"
  node --test --test-reporter=spec tests/examples/*.test.mjs
  say "page, end to end in Chromium"
  # Two at a time also on two cores: a browser waits much.
  node --test --test-concurrency=2 --test-reporter=spec tests/e2e/*.test.mjs
  say "page, end to end in Firefox and in WebKit"
  node --test --test-reporter=spec tests/engines/*.test.mjs
}

test_crate() {
  lint_rust
  test_rust
  test_mujoco
  test_wasm
}

# --- commands -------------------------------------------------------------------------------------

command=${1:-}
[ $# -eq 0 ] || shift
case $command in
  serve | setup | build | package | lint | bench | test) ;;
  *) usage >&2; exit 2 ;;
esac

setup_rust
setup_wasm_tools
setup_npm
PATH=$PWD/tools/node_modules/.bin:$PATH

case $command in
  setup)
    setup_browser
    setup_engines
    setup_mujoco
    setup_examples
    say "all there"
    ;;
  serve)
    build_package
    exec vite --config tools/vite.config.js "$@"
    ;;
  build)
    build_package
    build_page
    check_size
    ;;
  package)
    build_package
    build_npm
    ;;
  lint)
    lint_rust
    build_package
    lint_page
    ;;
  bench)
    setup_browser
    cargo bench --locked
    build_package
    node scripts/wasm-ratio.mjs
    build_page
    say "page"
    node scripts/bench-page.mjs
    ;;
  test)
    setup_browser
    setup_engines
    setup_mujoco
    setup_examples
    # The crate beside the page: neither keeps two cores busy. What the crate's part says comes when it has ended.
    crate_says=$(mktemp)
    set -m # with a process group of its own, so that it can be ended whole
    test_crate >"$crate_says" 2>&1 &
    crate=$!
    set +m
    trap 'kill -- -$crate 2>/dev/null || true; cat "$crate_says"; rm "$crate_says"' EXIT
    build_package
    check_size
    lint_page
    build_page
    build_npm
    test_page
    ended=0
    wait $crate || ended=$?
    trap - EXIT
    cat "$crate_says"
    rm "$crate_says"
    [ $ended = 0 ] || fail "the crate's tests failed: see above"
    say "every check and every test passed, in $((SECONDS / 60)) min $((SECONDS % 60)) s"
    ;;
esac
