# shellcheck shell=bash disable=SC2034
# Sourced, not run. The Debian packages that restframe needs, and how scripts get those
# that are missing.

packages_build=(
  g++ cmake ninja-build pkg-config
  libembree-dev libtinygltf-dev libtinyobjloader-dev libopenmesh-dev libopenexr-dev libglm-dev libtbb-dev
  libtomlplusplus-dev libcli11-dev libspdlog-dev libfmt-dev libmuparser-dev libstb-dev nlohmann-json3-dev
  libxxhash-dev libdraco-dev libmeshoptimizer-dev
)
packages_test=(libgtest-dev libgmock-dev assimp-testmodels)
packages_bench=(libbenchmark-dev)
packages_blender=(blender python3-numpy) # tests/clients.sh
packages_openimageio=(python3-openimageio python3-numpy)
packages_cluster=(slurmctld slurmd slurm-client munge) # tests/cluster.sh
packages_compare=(embree-tools) # tests/bench/compare.sh, with those of Blender
packages_package=(dpkg-dev file man-db groff-base lintian mandoc mmdebstrap) # tests/package.sh
packages_ci=(clang clang-format clang-tidy libclang-rt-14-dev lld shellcheck zsh fish)

missing_packages() {
  local package
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed* ]] || echo "$package"
  done
}

# Those that the package lists on this machine do not offer.
unknown_packages() {
  local package
  for package in "$@"; do
    [[ $(LC_ALL=C apt-cache policy "$package" 2>/dev/null) == *"Candidate: "[!\(]* ]] || echo "$package"
  done
}

# apt-get as root, directly or through sudo (which asks for a password only where somebody can answer).
# Only complaints are shown.
apt_get_as_root() {
  local root=()
  if [ "$(id -u)" -ne 0 ]; then
    root=(sudo)
    [ -t 0 ] || root+=(-n)
  fi
  "${root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C \
    apt-get -qq -o DPkg::Lock::Timeout=120 -o Acquire::Retries=3 "$@" >/dev/null
}

# Fails, naming them, if packages stay unknown after a fresh look at the package lists.
find_packages() {
  [ -n "$(unknown_packages "$@")" ] || return 0
  echo "packages: reading the package lists anew"
  apt_get_as_root update || echo "warning: apt-get update failed" >&2
  local unknown
  unknown=$(unknown_packages "$@" | xargs)
  [ -z "$unknown" ] && return 0
  echo "error: apt-get knows no package $unknown; restframe needs Debian 12 (bookworm), section main" >&2
  return 1
}

# Lists that are out of date name files that are gone, so a failure is worth one more try.
fetch_packages() {
  apt_get_as_root install -y --no-install-recommends "$@" && return 0
  echo "packages: trying again with new package lists"
  apt_get_as_root update &&
    apt_get_as_root install -y --no-install-recommends "$@" && return 0
  echo "error: could not install $(missing_packages "$@" | xargs) (the lines above say why)" >&2
  return 1
}

# Installs what is missing of the packages named; needs neither root nor a network if nothing is.
install_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "error: this script installs Debian packages, and here is no apt-get; needed: $*" >&2
    return 1
  fi
  local missing
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    echo "error: packages are missing and neither root nor sudo is at hand; as root, run:" \
      "apt-get install --no-install-recommends ${missing[*]}" >&2
    return 1
  fi
  echo "packages: installing ${missing[*]}"
  find_packages "${missing[@]}" && fetch_packages "${missing[@]}"
}
