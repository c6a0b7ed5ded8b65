#!/usr/bin/env bash
# Renders every scene, or those named, 640 pixels wide, and writes how long each takes to
# scenes/gallery.csv:
#     scenes/gallery.sh [fig08_ring engine ...]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scenes/program.sh
export LC_ALL=C

width=640
table=scenes/gallery.csv

fail() {
  echo "error: $*" >&2
  exit 2
}

all_scenes() { find scenes -mindepth 2 -maxdepth 2 -name scene.toml -printf '%h\n' | sed 's|.*/||' | sort; }

check_names() {
  local name
  for name in "$@"; do
    [ -f "scenes/$name/scene.toml" ] || fail "no scene $name; there are: $(all_scenes | xargs)"
  done
}

# 640 pixels wide, in the scene's own shape.
size_of() {
  local shape
  shape=$(sed -nE 's/^resolution *= *\[ *([0-9]+) *, *([0-9]+) *\].*/\1 \2/p' "scenes/$1/scene.toml")
  awk -v width=$width '{ printf "%dx%d", width, $2 * width / $1 + 0.5 }' <<<"${shape:-1280 720}"
}

seconds_since() { awk -v from="$1" -v to="$EPOCHREALTIME" 'BEGIN { printf "%.2f", to - from }'; }

# Renders the scene and prints its row of the table.
row_of() {
  local name=$1 folder=out/gallery/$1 begin
  rm -rf "$folder"
  begin=$EPOCHREALTIME
  "$build/restframe" render "scenes/$name/scene.toml" --size "$(size_of "$name")" \
    --output "$folder/picture.####.exr" --contact-sheet "out/gallery/$name.png" >&2 ||
    fail "scenes/$name/scene.toml: not rendered, exit code $?"
  echo "$name,$(find "$folder" -name '*.exr' | wc -l),$(seconds_since "$begin")"
}

# Scenes that are not rendered now keep their rows.
write_table() {
  {
    echo "scene,pictures,seconds"
    for name in $(all_scenes); do
      grep -h "^$name," out/gallery/rows.csv || grep -hs "^$name," "$table" || true
    done
  } >"$table.new"
  mv "$table.new" "$table"
}

[ $# -gt 0 ] || mapfile -t scenes < <(all_scenes)
[ $# -eq 0 ] || scenes=("$@")
check_names "${scenes[@]}"
say "the program"
install_packages "${packages_build[@]}"
build_program
mkdir -p out/gallery
: >out/gallery/rows.csv
for name in "${scenes[@]}"; do
  say "$name"
  row=$(row_of "$name")
  echo "$row" | tee -a out/gallery/rows.csv
done
write_table
say "done: $(awk -F, '{ sum += $3 } END { printf "%.1f", sum }' out/gallery/rows.csv) s for ${#scenes[@]} scenes"
echo "pictures: $PWD/out/gallery"
echo "times: $PWD/$table"
