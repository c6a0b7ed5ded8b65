# shellcheck shell=bash
# Sourced, not run, in the top folder. How the scripts get restframe.

source tests/support/packages.sh

say() { printf '\n== %s\n' "$*"; }

# Builds the program, where it was built before if it was, and sets `build` to that folder.
build_program() {
  if [ -f build/release/build.ninja ]; then
    build=build/release
  else
    build=build/demo
    cmake --preset release -B "$build" -DRESTFRAME_TESTS=OFF
  fi
  cmake --build "$build" --target restframe
}
