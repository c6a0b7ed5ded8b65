#!/usr/bin/env bash
# From a bare Debian 12 to a first animation: a blinking lattice that comes at 0.99 of the speed of light.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scenes/program.sh

scene=scenes/fig12_lattice_approach/scene.toml
pictures=out/fig12_lattice_approach
finished=$pictures/.finished # newer than the program and the scene: nothing is left to do

render() {
  if [ "$finished" -nt "$build/restframe" ] && [ "$finished" -nt "$scene" ]; then
    echo "already there; remove $PWD/$pictures to render again"
    return
  fi
  "$build/restframe" render "$scene" --output "$pictures/picture.####.exr" --overwrite
  touch "$finished"
}

if [ ! -f "$scene" ]; then
  echo "error: $PWD/$scene: no such file; the checkout is not complete" >&2
  exit 2
fi
say "1 of 3: packages"
install_packages "${packages_build[@]}"
echo "all there"
say "2 of 3: the program"
build_program
say "3 of 3: the pictures"
render

say "done: $(find "$pictures" -name '*.exr' | wc -l) pictures in $PWD/$pictures"
echo "EXR: $PWD/$pictures/picture.*.exr"
echo "PNG: $PWD/$pictures/picture.*.png"
