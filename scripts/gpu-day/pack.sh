#!/usr/bin/env bash
# Makes the pack of a GPU day: programs, kernels, scenes and rays for a machine that has a driver and nothing else:
#   scripts/gpu-day.sh pack FILE.tar.xz [--scene NAME=INPUT | --formats FILE | --levels N]... [--cameras CAMERAS.json]
#     [--peers DIR] [--engine PROGRAM] [--bin DIR]
# A scene is any INPUT of voxc build; without one it is builtin:terrain:1024. --formats and --levels are of the scenes behind them:
# formats, one a line, NAME<tab>FORMAT[<tab>PASSES], in place of those of formats.txt, and 2^N voxels an axis in place of 1024.
# Peers are tracers by hand with a scene of their own: a folder with svdag.comp, t_svdag.cpp and so on, as its run script compiles
# them. PROGRAM is that of examples/engine.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$here/../..
file=$(realpath -m "$1")
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
scenes=() peers='' engine='' bin=$root/build/release/bin cameras=$here/cameras.json
formats=$here/formats.txt levels=10
while [ $# -gt 0 ]; do
  case $1 in
  --scene) scenes+=("$levels $formats $2") ;; # As they are now.
  --formats) formats=$(realpath "$2") ;;
  --levels) levels=$2 ;;
  --engine) engine=$(realpath "$2") ;;
  --peers) peers=$(realpath "$2") scenes+=("10 $formats reference=$work/reference.ply") ;;
  --cameras) cameras=$(realpath "$2") ;;
  --bin) bin=$(realpath "$2") ;;
  *) echo "gpu-day: unknown option '$1'; there are --scene, --formats, --levels, --cameras, --peers, --engine and --bin" >&2; exit 2 ;;
  esac
  shift 2
done
pack=$work/gpu-day
mkdir -p "$pack"/{bin,lib,scenes,formats,kernels,lattice,cuda,peers}

# Programs, and the libraries that a machine may lack.
cp "$bin/voxc" "$bin/voxc-gpu-day" ${engine:+"$engine"} "$pack/bin"
strip "$pack"/bin/*
ldd "$pack"/bin/* | awk '$3 ~ /^\// {print $3}' | sort -u |
  grep -v -E '/(libc|libm|libdl|libpthread|librt|ld-linux[^/]*)\.so' | xargs -I{} cp -L {} "$pack/lib"
# What NVIDIA's driver asks of a system without a display.
(cd "$work" && apt-get download libglvnd0 libgl1 libglx0 libegl1 libopengl0 libgles2 libx11-6 libxext6 libxcb1 libxau6 \
  libxdmcp6 libbsd0 libmd0 >/dev/null 2>&1 && for package in *.deb; do dpkg -x "$package" display; done)
for library in "$work"/display/usr/lib/*/lib*.so.[0-9]; do cp -L "$library" "$pack/lib"; done
strip "$pack"/lib/*
cp "$here/run.sh" "$pack"
cp "$cameras" "$pack/cameras.json"

# Scenes, small: shapes shared, colours apart.
if [ -n "$peers" ]; then
  (cd "$work" && g++ -O2 -std=c++20 "$peers/dump.cpp" -o dump -pthread && ./dump 1024 reference >&2)
fi
if [ ${#scenes[@]} = 0 ]; then
  scenes=("10 $here/formats.txt terrain=builtin:terrain:1024")
fi
for scene in "${scenes[@]}"; do
  read -r levels formats scene <<<"$scene"
  "$bin/voxc" build "R($((levels - 8))^3) M(2^3) M(2^3) M(2^3) M(2^3)" "${scene#*=}" --share-grids --values-apart \
    --short-pointers --compress -o "$pack/scenes/${scene%%=*}.hvx" --quiet
  of=$(basename "$formats" .txt)
  grep -v '^#' "$formats" >"$pack/formats/$of.txt"
  printf '%s\t%s\n' "${scene%%=*}" "$of" >>"$pack/scenes.txt"
done

# Kernels: exact and fast ones that round to nearest, and exact ones that rely on nothing.
kernel() { # NAME KIND FORMAT OPTION...
  "$bin/voxc" compile "$3" --emit=spirv --loops whole "${@:4}" -o "$work/kernel" --quiet
  spirv-val --target-env vulkan1.2 "$work/kernel/intersect.spv"
  mv "$work/kernel/intersect.spv" "$1.$2.spv"
}
for formats in "$pack"/formats/*.txt; do
  kernels=$pack/kernels/$(basename "$formats" .txt)
  mkdir "$kernels"
  while IFS=$'\t' read -r name format passes; do
    # shellcheck disable=SC2086 # Passes are words.
    for kind in exact fast any; do
      # What rounding gains shows in one format of each kind.
      if [ $kind = any ] && ! [[ $name =~ ^(octants|dag|masked-apart)$ ]]; then continue; fi
      case $kind in
      exact) options='--arithmetic nearest' ;;
      fast) options='--arithmetic nearest --precision fast' ;;
      any) options='--arithmetic any' ;;
      esac
      kernel "$kernels/$name" $kind "$format" $passes $options
    done
  done <"$formats"
done

# Hard rays: small volumes of every kind of level.
for program in lattice compare; do
  glslangValidator -V --target-env vulkan1.2 --quiet "$root/tools/gpu-day/$program.comp" -o "$pack/lattice/$program.spv"
done
number=0
for format in 'R(6^3)' 'D(3^3,6) R(3^3)' 'G(6)' 'S(6)' 'M(3^3) M(3^3)' 'R(2^3) G(4)' 'H(3^3) G(3)'; do
  number=$((number + 1))
  "$bin/voxc" build "$format" builtin:terrain:64 -o "$pack/lattice/$number.hvx" --compress --quiet
  for kind in nearest any; do kernel "$pack/lattice/$number" $kind "$format" --arithmetic $kind; done
done

# CUDA: the header's functions as PTX, and their text for a toolkit that may be there.
for name in octants dag; do
  IFS=$'\t' read -r _ format passes < <(grep -P "^$name\t" "$here/formats.txt")
  for kind in exact fast; do # Each with as many registers as it likes, and with few.
    mkdir -p "$pack/cuda/$name.$kind"
    # shellcheck disable=SC2086 # Passes are words.
    "$bin/voxc" compile "$format" $passes --precision $kind --emit=header --language cuda --name scene \
      -o "$pack/cuda/$name.$kind" --quiet
    for blocks in 1 16; do
      clang++-19 -x cuda --cuda-device-only --cuda-gpu-arch=sm_70 -nocudainc -nocudalib -std=c++20 -O3 -DBLOCKS=$blocks \
        -Wno-unknown-cuda-version -I "$pack/cuda/$name.$kind" -S "$root/tools/gpu-day/trace.cu" \
        -o "$pack/cuda/$name.clang-$kind-$blocks.ptx"
    done
  done
done
cp "$root/tools/gpu-day/trace.cu" "$pack/cuda"

# NanoVDB's own header on the voxels of the first scene, where its header and nvcc are at hand.
nvcc=$(PATH=$PATH:/usr/local/cuda/bin command -v nvcc || true)
if [ -n "$nvcc" ] && [ -e /usr/include/nanovdb/NanoVDB.h ]; then
  "$nvcc" -ptx -arch=compute_75 -O3 -std=c++17 --expt-relaxed-constexpr "$root/tools/gpu-day/nanovdb.cu" -o "$pack/cuda/nanovdb.ptx"
  g++ -O2 -std=c++17 -static "$root/tools/gpu-day/nanovdb-grid.cpp" -o "$pack/bin/nanovdb-grid"
fi

# What the engine shows.
if [ -n "$engine" ]; then
  PYTHONPATH=$root/python VOXC_LIBRARY=$bin/../lib/libvoxc.so VOXC=$bin/voxc /usr/bin/python3 "$root/examples/engine/chunks.py" \
    "$pack/chunks" >/dev/null
fi

# Tracers by hand: their kernels, and what makes their nodes.
if [ -n "$peers" ]; then
  for kind in own aadf aadf3 svdag; do # Without their measurements.
    sed 's/\breport("/if(0) report("/' "$peers/t_$kind.cpp" >"$work/t_$kind.cpp"
    g++ -O2 -std=c++20 -static -I "$peers" "$work/t_$kind.cpp" -o "$pack/peers/t_$kind" -pthread
    strip "$pack/peers/t_$kind"
  done
  for kind in aadf aadf3 tree64v4 svdag; do
    glslangValidator -V --quiet "$peers/$kind.comp" -o "$pack/peers/$kind.spv"
  done
  glslangValidator -V --quiet -DSTACK "$peers/svdag.comp" -o "$pack/peers/svdag_stack.spv"
fi

tar -C "$work" -c gpu-day | xz -T0 -6 >"$file"
echo "gpu-day: $file, $(($(stat -c %s "$file") / 1000000)) MB: scripts/gpu-day.sh run FILE OUT there"
