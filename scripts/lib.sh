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

# build PRESET: configures and builds build/PRESET.
build() {
  say "Building build/$1"
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1"
}
