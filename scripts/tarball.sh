#!/usr/bin/env bash
# Makes a tarball of the tools: unpacked anywhere, bin/voxc runs, with its window, on Linux with glibc 2.28 or later. Beside it are the
# library for C with its headers, the manual, completion for shells, the licences of all that is inside and a bill of materials.
#
# Usage: scripts/tarball.sh FOLDER [BUILD]
# BUILD (default: build/release) is built as far as is needed (scripts/portable.sh).
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -ge 1 ] || { echo "usage: scripts/tarball.sh FOLDER [BUILD]" >&2; exit 1; }
readonly folder=$1 build=${2:-build/release}

scripts/portable.sh "$build"
python3 -B scripts/portable/needs.py "$build"/portable/bin/voxc "$build"/portable/lib/lib*.so.[0-9]
version=$("$build"/portable/bin/voxc --version | cut -d ' ' -f 2)
moment=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
readonly name=voxc-$version-linux-$(uname -m)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
readonly root=$work/$name share=$work/$name/share

mkdir -p "$root/include" "$share"/{man/man1,bash-completion/completions,zsh/site-functions,fish/vendor_completions.d,voxc}
cp -r "$build/portable/bin" "$build/portable/lib" "$root"
cp -r include/voxc-c "$root/include"
voxc=$root/bin/voxc
"$voxc" manual -o "$share/man/man1"
"$voxc" completion bash > "$share/bash-completion/completions/voxc"
"$voxc" completion zsh > "$share/zsh/site-functions/_voxc"
"$voxc" completion fish > "$share/fish/vendor_completions.d/voxc.fish"
mkdir "$share/voxc/report"
(cd tools/report && find . -name '*.py' -o -name '*.html' -o -name '*.css' -o -name '*.js') |
  tar -C tools/report -c -T - | tar -C "$share/voxc/report" -x
python3 -B scripts/portable/contents.py "$build" "$root" "$version" "$moment"
cp LICENSE "$root"
cp docs/install.md "$root/README.md"
echo "$version" > "$root/VERSION"
chmod -R u=rwX,go=rX "$root"

mkdir -p "$folder"
tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner --mtime="@$moment" -c "$name" | xz -T 0 > "$folder/$name.tar.xz"
printf '%s, %d bytes\n' "$folder/$name.tar.xz" "$(stat -c %s "$folder/$name.tar.xz")"
