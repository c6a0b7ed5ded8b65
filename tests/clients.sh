#!/usr/bin/env bash
# Other people's programs read what restframe writes: Blender and OpenImageIO.
#     tests/clients.sh [PROGRAM]        build/release/restframe unless given
# Installs Debian's blender, python3-numpy and python3-openimageio (530 MB) where they are missing. Says so in
# a line and goes on where they can not be had, unless RESTFRAME_NEED_CLIENTS is set. A line for each thing
# that is compared, with the numbers.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "${1:-$here/../build/release/restframe}")
cd "$here"
# shellcheck source=SCRIPTDIR/support/packages.sh
source support/packages.sh
scripts=$PWD/clients
python=/usr/bin/python3 # Debian's, which the packages are for, whatever comes first on PATH

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder/config XDG_CACHE_HOME=$folder/cache PYTHONDONTWRITEBYTECODE=1
failed=()

# part NAME COMMAND...: goes on after a failure, which is named at the end.
part() {
  local name=$1 begin=$SECONDS
  shift
  "$@" || failed+=("$name")
  echo "clients: $name: $((SECONDS - begin)) s"
}

# have NAME PACKAGE...: whether they are there now.
have() {
  local name=$1 said
  shift
  said=$(install_packages "$@" 2>&1) && return 0
  echo "clients: $name: skipped, its packages can not be had: $(tail -n 1 <<<"$said")"
  [ -z "${RESTFRAME_NEED_CLIENTS:-}" ] || failed+=("$name")
  return 1
}

# render NAME [SED...]: layers.toml, changed, as NAME.exr.
render() {
  local name=$1
  shift
  sed "$@" -e '' "$scripts/layers.toml" >"$folder/$name.toml"
  timeout -s KILL 60 "$program" render "$folder/$name.toml" --output "$folder/$name.exr" --quiet
}

# The same picture with every compression of OpenEXR, in a file for each layer, in part, and for two eyes.
render_layers() {
  local kind
  cp "$scripts/square.obj" "$folder"
  for kind in none rle zips zip piz pxr24 dwaa dwab; do
    render "$kind" -e "s/^compression = .*/compression = \"$kind\"/" || return 1
  done
  render split -e 's/^compression = .*/&\nsplit = true/' &&
    render crop -e 's/^resolution = .*/&\ncrop = [8, 10, 64, 40]/' &&
    render stereo -e 's/^\[animation\]/[camera.stereo]\nseparation = 0.4\nconvergence = 6\n&/'
}

# in_blender SCRIPT ARGUMENTS...: what it says itself, and what Blender says where it does not come to its end.
in_blender() {
  local script=$1 log=$folder/blender.log status=0
  shift
  timeout -s KILL 60 blender --background --factory-startup --python-exit-code 1 \
    --python "$scripts/$script" -- "$@" >"$log" 2>&1 || status=$?
  grep -E '^(ok|FAULT|add-on): ' "$log" || true
  if [ "$status" -ne 0 ] && ! grep -q '^FAULT: ' "$log"; then tail -n 40 "$log"; fi
  return "$status"
}

part pictures render_layers
if have openimageio "${packages_openimageio[@]}"; then
  part openimageio timeout -s KILL 60 "$python" "$scripts/openimageio_check.py" "$folder"
fi
if have blender "${packages_blender[@]}"; then
  part 'layers in Blender' in_blender blender_layers.py "$folder"
  part 'scenes from Blender' "$scripts/blender.sh" "$program"
  part 'add-on in Blender' in_blender addon_check.py "$program"
fi

if [ ${#failed[@]} -gt 0 ]; then
  printf 'clients: FAILED: %s\n' "${failed[@]}"
  exit 1
fi
echo "clients: all that could be had agree, after $SECONDS s"
