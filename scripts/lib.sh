# What ./demo and ./check share: installing packages and building a preset. Sourced from the repository's root.
set -euo pipefail

say() { printf '\n== %s\n' "$*"; }

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

package_lists=(scripts/packages.txt)

packages() { sed -e 's/#.*//' -e '/^ *$/d' "${package_lists[@]}"; }

# One call to dpkg for all names, so that apt is only started when something is missing.
missing_packages() {
  comm -23 <(packages | sort) \
    <(packages | xargs dpkg-query -W -f='${db:Status-Status} ${Package}\n' 2>/dev/null | sed -n 's/^installed //p' | sort)
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo "$@"
  else
    fail "installing packages needs root or sudo"
  fi
}

install_packages() {
  command -v dpkg-query >/dev/null || fail "packages are installed by apt; elsewhere, install those of scripts/packages.txt"
  local missing
  missing=$(missing_packages)
  [ -z "$missing" ] && return
  say "Installing" $missing
  as_root apt-get -qq update
  as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq install --no-install-recommends --yes $missing
}

# What a preset builds over where that is not this system: libraries for another processor, fetched once.
fetch_sysroot() { # PRESET
  [ "$1" != aarch64 ] || [ -d build/aarch64-sysroot ] || scripts/sysroot.sh arm64 build/aarch64-sysroot
}

# What a build is configured with, beside its preset.
configuration=(-DVOXC_APPS=ON)

# build PRESET [TARGET...]: configures and builds build/PRESET, all of it or these targets. One from nothing compiles files
# together; `cmake --preset PRESET -DVOXC_FIRST_BUILD=OFF` is for who goes on to change them.
build() {
  local preset=$1
  shift
  say "Building ${*:-everything} in build/$preset; the first time takes minutes, later ones a moment"
  fetch_sysroot "$preset"
  local first=
  [ -e "build/$preset/CMakeCache.txt" ] || first=-DVOXC_FIRST_BUILD=ON
  cmake --preset "$preset" $first "${configuration[@]}" >/dev/null
  NINJA_STATUS="  file %f of %t, after %es: " cmake --build --preset "$preset" ${1:+--target "$@"}
}
