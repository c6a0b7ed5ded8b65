#!/usr/bin/env bash
# Makes the Debian packages of a build and tries them: what is in them, the program and a project that
# links the library where they are unpacked, and again where they are installed, for that long.
#     tests/package.sh [--fresh] [BUILD]        build/release unless given
# --fresh: on a Debian 12 with nothing else on it, too, which takes a minute more. What this machine does
# not allow is reported as skipped.
set -euo pipefail
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# shellcheck source=SCRIPTDIR/support/packages.sh
source "$tests/support/packages.sh"
fresh=no
if [ "${1:-}" = --fresh ]; then
  fresh=yes
  shift
fi
build=$(realpath "${1:-$tests/../build/release}")
work=$(mktemp -d)
installed=no

clean_up() {
  if [ "$installed" = yes ]; then remove_packages || true; fi
  rm -rf "$work"
}
trap clean_up EXIT

say() { printf 'package: %s\n' "$*"; }
fail() {
  say "FAILED: $*" >&2
  exit 1
}

make_packages() {
  cmake --build "$build" --target restframe restframe_documents >"$work/log" || fail "$(<"$work/log")"
  (cd "$build" && cpack --config CPackConfig.cmake -B "$work/debian") >"$work/log" 2>&1 ||
    fail "$(<"$work/log")"
  program_package=$(echo "$work"/debian/restframe_*.deb)
  library_package=$(echo "$work"/debian/librestframe-dev_*.deb)
  version=$("$build/restframe" --version)
  version=${version#restframe }
  chmod -R go+rX "$work" # apt reads packages as a user of its own
}

# Everything belongs to root, may be read by all, and lies below /usr.
check_entries() {
  local entries
  entries=$(dpkg-deb -c "$1" | awk '$2 != "root/root" || $6 !~ "^./usr/" ||
    $1 !~ ($6 ~ /\/$/ || $6 ~ "/bin/" ? ".rwxr-xr-x" : "-rw-r--r--")')
  [ -z "$entries" ] || fail "$(basename "$1") has entries of other owners, rights or places: $entries"
}

check_fields() {
  local name wanted
  for name in libembree3-3 libopenexr-3-1-30 libtbb12 libstdc++6; do
    [[ $(dpkg-deb -f "$program_package" Depends) == *"$name "* ]] || fail "restframe does not depend on $name"
  done
  # As restframe-config.cmake asks for them: TBB is in libtbb-dev, nlohmann_json in nlohmann-json3-dev.
  mapfile -t wanted < <(sed -n 's/^find_dependency(\([^ )]*\).*/\1/p' "$tests/../src/package/restframe-config.cmake")
  for name in "${wanted[@]}"; do
    [ "$name" != Threads ] || continue
    dpkg-deb -f "$library_package" Depends | grep -qiE "(lib)?${name//_/-}[0-9]*-dev" ||
      fail "librestframe-dev does not depend on the package of $name"
  done
  for name in "$program_package" "$library_package"; do
    [ "$(dpkg-deb -f "$name" Version)" = "$version-1" ] || fail "$name is not of version $version"
  done
}

check_files() {
  local file
  for file in bin/restframe share/man/man1/restframe.1.gz share/bash-completion/completions/restframe \
    share/zsh/vendor-completions/_restframe share/fish/vendor_completions.d/restframe.fish \
    share/doc/restframe/{README.md,copyright,changelog.gz,changelog.Debian.gz,scenes/reference.md} \
    share/doc/librestframe-dev/{copyright,changelog.gz,examples/main.cpp} lib/cmake/restframe/restframe-config.cmake; do
    [ -s "$work/root/usr/$file" ] || fail "/usr/$file is missing"
  done
  file=/usr/share/restframe/restframe_addon.zip
  if [ -d "$tests/../importers/blender" ] && [ ! -s "$work/root$file" ]; then fail "$file is missing"; fi
}

check_packages() {
  check_entries "$program_package"
  check_entries "$library_package"
  check_fields
  dpkg-deb -x "$program_package" "$work/root"
  dpkg-deb -x "$library_package" "$work/root"
  check_files
  say "contents: $(du -h --apparent-size "$program_package" "$library_package" |
    awk '{ sub(".*/", "", $2); print $2 " (" $1 ")" }' | paste -sd ' ')"
}

# A first upload to Debian itself would close a bug report.
check_with_lintian() {
  if ! command -v lintian >/dev/null; then
    say "lintian: skipped, it is not installed"
    return
  fi
  lintian --allow-root --fail-on error,warning --suppress-tags initial-upload-closes-no-bugs \
    "$program_package" "$library_package" || fail "lintian"
  say "lintian: nothing found"
}

check_manual() {
  local manual=$work/restframe.1 said=''
  gunzip -c "$work/root/usr/share/man/man1/restframe.1.gz" >"$manual"
  if command -v mandoc >/dev/null; then said+=$(mandoc -T lint -W warning "$manual" || true); fi
  if command -v man >/dev/null && command -v groff >/dev/null; then
    said+=$(LC_ALL=C.UTF-8 man --warnings -l "$manual" 2>&1 >/dev/null)
  else
    say "manual: skipped, man is not installed"
  fi
  [ -z "$said" ] || fail "the man page: $said"
}

# A picture of its own lattice, and one of a scene that came with it.
try_program() {
  local program=$1 scenes=$2 folder
  folder=$(mktemp -d "$work/pictures.XXXX")
  [ "$("$program" --version)" = "restframe $version" ] || fail "$program is not of version $version"
  "$program" lattice -o "$folder/lattice.glb" --cells 2x2x2 >/dev/null
  "$program" render "$folder/lattice.glb" --size 64x36 --samples 1 -q -o "$folder/lattice.exr"
  "$program" render "$scenes/clocks/scene.toml" --pictures 0 --size 64x36 --samples 1 -q -o "$folder/clocks.exr"
  if [ ! -s "$folder/lattice.exr" ] || [ ! -s "$folder/clocks.exr" ]; then fail "$program rendered no pictures"; fi
}

try_library() {
  cmake -DSOURCE_DIR="$tests" -DBUILD_DIR="$work" -DVERSION="$version" -DGENERATOR=Ninja -DCOMPILER=c++ \
    -DPREFIX="$1" -P "$tests/consumer_test.cmake" >"$work/log" 2>&1 || fail "$(<"$work/log")"
}

try_unpacked() {
  try_program "$work/root/usr/bin/restframe" "$work/root/usr/share/doc/restframe/scenes"
  try_library "$work/root/usr"
  say "unpacked: the program renders, a project links the library"
}

remove_packages() {
  apt_get_as_root purge -y restframe librestframe-dev && installed=no
}

why_not_installed() {
  if dpkg-query -W restframe >/dev/null 2>&1 || dpkg-query -W librestframe-dev >/dev/null 2>&1; then
    echo "this machine has a restframe already"
  elif [ "$(id -u)" -ne 0 ] && ! sudo -n true 2>/dev/null; then
    echo "neither root nor sudo is at hand"
  elif ! apt_get_as_root install -s --no-install-recommends "$program_package" "$library_package" 2>/dev/null; then
    echo "apt-get can not have what it depends on"
  fi
}

try_installed() {
  local why before
  why=$(why_not_installed)
  if [ -n "$why" ]; then
    say "installed: skipped, $why"
    return
  fi
  before=$(dpkg-query -W)
  installed=yes
  apt_get_as_root install -y --no-install-recommends "$program_package" "$library_package" 2>"$work/log" ||
    fail "apt-get install: $(<"$work/log")"
  try_program /usr/bin/restframe "$work/root/usr/share/doc/restframe/scenes"
  # Minimal machines leave manuals out.
  [ ! -e /usr/share/man/man1/restframe.1.gz ] || [ "$(man -w restframe)" = /usr/share/man/man1/restframe.1.gz ] ||
    fail "man does not find the manual"
  remove_packages || fail "apt-get purge"
  [ "$(dpkg-query -W)" = "$before" ] || fail "other packages are there now than before"
  if [ -e /usr/bin/restframe ] || [ -e /usr/share/doc/restframe ]; then fail "something is left behind"; fi
  say "installed: the program renders; removed again"
}

try_fresh() {
  if [ "$(id -u)" -ne 0 ] || ! command -v mmdebstrap >/dev/null; then
    say "fresh machine: skipped, it takes root and mmdebstrap"
  elif ! mmdebstrap --quiet --variant=apt bookworm "$work/fresh" >"$work/log" 2>&1; then
    say "fresh machine: skipped, $(tail -n 1 "$work/log")"
  else
    cp "$program_package" "$work/fresh/root/restframe.deb"
    cp /etc/resolv.conf "$work/fresh/etc/"
    chroot "$work/fresh" sh -ec 'apt-get update && cd /root &&
      DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends ./restframe.deb &&
      restframe lattice -o lattice.glb --cells 2x2x2 && restframe render lattice.glb --size 64x36 -o lattice.exr &&
      test -s lattice.exr' >"$work/log" 2>&1 || fail "on a fresh machine: $(<"$work/log")"
    say "fresh machine: the program renders"
  fi
}

if ! said=$(install_packages "${packages_package[@]}" 2>&1); then say "$(tail -n 1 <<<"$said")"; fi
if ! command -v dpkg-shlibdeps >/dev/null || ! command -v file >/dev/null; then
  say "skipped, Debian's tools are missing: dpkg-dev, file"
  exit 0
fi
make_packages
check_packages
check_with_lintian
check_manual
try_unpacked
try_installed
if [ "$fresh" = yes ]; then try_fresh; fi
