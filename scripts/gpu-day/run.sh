#!/bin/sh
# Measures all that a pack holds on the GPU of this machine, of which it needs a driver and nothing else; in the unpacked pack:
#   sh run.sh OUT [SECONDS=480] [DEVICE]
# It ends after so many seconds, and goes on where it ended when it is run again. OUT has gpu-day.json, results.jsonl, which
# `voxc bench report` reads, and table.md.
set -u
pack=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1/cells" "$1/lattice" "$1/volumes" "$1/lib" "$1/texts"
out=$(cd "$1" && pwd)
seconds=${2:-480} device=${3:-}
start=$(date +%s)
PATH=$PATH:/sbin:/usr/sbin
export PATH

say() { echo "gpu-day: $(($(date +%s) - start)) s: $*"; }
is_over() { [ $(($(date +%s) - start)) -ge "$seconds" ]; }

# Libraries that this machine lacks, and no others: a driver brings its own.
for library in "$pack"/lib/*; do
  name=$(basename "$library")
  ldconfig -p | grep -q -F "$name " || ln -sf "$library" "$out/lib/$name"
done
LD_LIBRARY_PATH=$out/lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}
export LD_LIBRARY_PATH
if ! "$pack/bin/voxc" --version >/dev/null 2>&1; then # Those here are older than what the programs need.
  for library in "$pack"/lib/*; do ln -sf "$library" "$out/lib/"; done
fi
"$pack/bin/voxc" devices | tee "$out/devices.txt"
if ! grep -q '^0: ' "$out/devices.txt"; then
  echo "gpu-day: there is no Vulkan device; 'VK_LOADER_DEBUG=all $pack/bin/voxc devices' says what the loader found" >&2
  exit 3
fi
if command -v nvidia-smi >/dev/null; then nvidia-smi -q -d CLOCK,POWER >"$out/nvidia-smi.txt" 2>&1; fi

# One figure file, unless it is there; a failure is a sentence in its place, and the next one is begun.
cell() { # FOLDER NAME PROGRAM ARGUMENT...
  into=$out/$1/$2
  shift 2
  if [ -e "$into.json" ] || [ -e "$into.failed" ] || is_over; then return; fi
  "$@" -o "$into.part" 2>"$into.error"
  status=$?
  if [ -e "$into.part" ]; then
    mv "$into.part" "$into.json"
  elif [ -s "$into.error" ]; then
    sed 's/^voxc-gpu-day: error: //' "$into.error" | head -n 1 >"$into.failed"
  else
    echo "the program ended with status $status" >"$into.failed"
  fi
  say "$(basename "$into")$([ -e "$into.failed" ] && echo ": $(cat "$into.failed")")"
  rm -f "$into.error"
}

gpu_day=$pack/bin/voxc-gpu-day
jobs=$(nproc)
tab=$(printf '\t')

# Right before fast: hard rays, as many as ten thousand million in all.
for volume in "$pack"/lattice/*.hvx; do
  number=$(basename "$volume" .hvx)
  cell lattice "$number" "$gpu_day" lattice "$volume" --kernel "$pack/lattice/$number.nearest.spv" \
    --kernel "$pack/lattice/$number.any.spv" --programs "$pack/lattice" --device "$device" --label "$number" --seed "$number" \
    --count "${GPU_DAY_RAYS:-750000000}" --seconds "${GPU_DAY_RAY_SECONDS:-5}"
done

while IFS="$tab" read -r name of; do
  scene=$pack/scenes/$name.hvx formats=$pack/formats/$of.txt
  # Volumes, as many at a time as there are processors; rays with the oracle's hits meanwhile.
  running=0
  while IFS="$tab" read -r format_name format passes; do
    volume=$out/volumes/$name.$format_name.hvx
    if [ -e "$volume" ] || is_over; then continue; fi
    # shellcheck disable=SC2086 # Passes are words.
    "$pack/bin/voxc" build "$format" "$scene" $passes --threads 1 -o "$volume" --quiet </dev/null &
    running=$((running + 1))
    if [ $((running % jobs)) -eq 0 ]; then wait; fi
  done <"$formats"
  rm -f "$out/cells/$name.rays.failed"
  if ! is_over && ! "$gpu_day" rays "$scene" "$pack/cameras.json" --scene "$name" --size "${GPU_DAY_SIZE:-3840x2160}" \
    -o "$out/rays/$name" 2>"$out/rays.error"; then
    sed 's/^voxc-gpu-day: error: //' "$out/rays.error" | head -n 1 >"$out/cells/$name.rays.failed"
  fi
  if [ "$name" = reference ] && [ -e "$pack/peers/svdag.spv" ] && [ ! -e "$out/peers" ] && ! is_over; then
    mkdir -p "$out/nodes"
    (cd "$out/nodes" && for kind in 'own 1024 tree64.bin tree64v4.bin' 'aadf 1024 aadf.bin' 'aadf3 1024 aadf3.bin' \
      'svdag 1024 svdag.bin'; do
      # shellcheck disable=SC2086 # A program and its arguments.
      "$pack"/peers/t_$kind >/dev/null &
    done && wait) && mv "$out/nodes" "$out/peers"
  fi
  wait
  if is_over; then break; fi
  say "volumes and rays of $name"
  while IFS="$tab" read -r format_name format passes; do
    kernels=''
    for kernel in "$pack/kernels/$of/$format_name".*.spv; do kernels="$kernels --kernel $kernel"; done
    # shellcheck disable=SC2086 # Kernels are words.
    cell cells "$name.$format_name" "$gpu_day" measure --rays "$out/rays/$name" --scene "$name" --label "$format $passes" \
      --device "$device" --seconds 0.05 --volume "$out/volumes/$name.$format_name.hvx" $kernels </dev/null
  done <"$formats"
  first=$(head -n 1 "$pack/scenes.txt" | cut -f 1)
  if [ "$name" != "$first" ]; then continue; fi # What follows tells of programs more than of scenes.
  for code in octants.clang dag.clang octants.nvcc dag.nvcc; do
    format_name=${code%.*} compiler=${code#*.} codes=$pack/cuda
    if [ "$compiler" = nvcc ]; then
      nvcc=$(PATH=$PATH:/usr/local/cuda/bin command -v nvcc) || continue
      codes=$out/cuda
      mkdir -p "$codes"
      for kind in exact-1 exact-16 fast-1 fast-16; do
        if [ -e "$codes/$code-$kind.ptx" ]; then continue; fi
        LD_LIBRARY_PATH='' "$nvcc" -arch=native -O3 -std=c++20 -DBLOCKS=${kind#*-} -I "$pack/cuda/$format_name.${kind%-*}" \
          -ptx "$pack/cuda/trace.cu" -o "$codes/$code-$kind.ptx" >"$codes/$code-$kind.txt" 2>&1 &
      done
      wait
    fi
    cell cells "$name.$format_name-cuda-$compiler" "$gpu_day" measure --rays "$out/rays/$name" --scene "$name" \
      --label "$format_name, CUDA by $compiler" --device "$device" --seconds 0.05 \
      --volume "$out/volumes/$name.$format_name.hvx" --cuda "$codes/$code-exact-1.ptx" --cuda "$codes/$code-exact-16.ptx" \
      --cuda "$codes/$code-fast-1.ptx" --cuda "$codes/$code-fast-16.ptx"
  done
  if [ -e "$out/peers" ]; then
    for peer in tree64v4 aadf aadf3 svdag svdag_stack; do
      cell cells "$name.hand-$peer" "$gpu_day" measure --rays "$out/rays/$name" --scene "$name" --label "by hand: $peer" \
        --device "$device" --seconds 0.05 --peer "$pack/peers/$peer.spv" --nodes "$out/peers/${peer%_stack}.bin"
    done
  fi
  if [ -e "$pack/cuda/nanovdb.ptx" ]; then
    if [ ! -e "$out/nanovdb/grid.bin" ] && ! is_over; then
      mkdir -p "$out/nanovdb"
      "$pack/bin/voxc" export "$scene" -o "$out/nanovdb/scene.nvdb" --quiet &&
        "$pack/bin/nanovdb-grid" "$out/nanovdb/scene.nvdb" "$out/nanovdb/grid.bin"
    fi
    cell cells "$name.hand-nanovdb" "$gpu_day" measure --rays "$out/rays/$name" --scene "$name" --label "NanoVDB" \
      --device "$device" --seconds 0.05 --cuda "$pack/cuda/nanovdb.ptx" --nodes "$out/nanovdb/grid.bin"
  fi
  # From farther and farther away.
  if ! is_over; then "$gpu_day" distances "$scene" --side "${GPU_DAY_SIDE:-1024}" -o "$out/rays/$name-distances"; fi
  for format_name in octants octants-small dag grid-dag; do
    cell cells "$name.$format_name-distances" "$gpu_day" measure --rays "$out/rays/$name-distances" \
      --scene "$name, distances" --label "$format_name" --device "$device" --seconds 0.02 \
      --volume "$out/volumes/$name.$format_name.hvx" --kernel "$pack/kernels/$of/$format_name.exact.spv" \
      --kernel "$pack/kernels/$of/$format_name.fast.spv"
  done
  if [ -e "$out/peers/aadf.bin" ]; then
    cell cells "$name.hand-aadf-distances" "$gpu_day" measure --rays "$out/rays/$name-distances" --scene "$name, distances" \
      --label "by hand: aadf" --device "$device" --seconds 0.02 --peer "$pack/peers/aadf.spv" --nodes "$out/peers/aadf.bin"
  fi
  # A part of the volume in memory: hits are those of all of it, or the difference is told.
  rays=$(find "$out/rays/$name" -name '*-tiles.rays' | sort | head -n 1) paged=$out/volumes/$name.paged.hvx
  if [ ! -e "$paged" ] && ! is_over; then
    "$pack/bin/voxc" build 'G(10)' "$scene" --whole-level-dedup --compress -o "$paged" --quiet
  fi
  for budget in 8MiB 12MiB 16MiB 24MiB; do
    text=$out/texts/pages-$budget
    if [ -e "$text.json" ] || is_over; then continue; fi
    "$pack/bin/voxc" trace "$paged" --rays "$rays" -o "$out/paged.hits" --device "${device:-0}" \
      --device-memory $budget --repeat 3 --stats "$text.json" --quiet 2>"$text.error" &&
      { cmp "$out/paged.hits" "${rays%.rays}.hits" >"$text.difference" 2>&1 || cat "$text.difference"; }
    say "pages in $budget"
  done
  # Edits, which a tracer on the device follows.
  for format_name in octants dag; do
    cell cells "$name.$format_name-edits" "$gpu_day" measure --rays "$out/rays/$name" --scene "$name, edits" --label "$format_name" \
      --device "$device" --seconds 0.01 --set bounce --follow --volume "$out/volumes/$name.$format_name.hvx" \
      --kernel "$pack/kernels/$of/$format_name.exact.spv"
  done
  # A ray-tracing pipeline.
  if [ -e "$pack/bin/engine" ] && [ ! -e "$out/texts/engine.txt" ] && ! is_over; then
    "$pack/bin/engine" "$pack/chunks" "$out/engine" "${GPU_DAY_COLUMNS:-3840}" "${GPU_DAY_ROWS:-2160}" >"$out/texts/engine.txt" 2>&1
    "$pack/bin/voxc" trace "$pack/chunks/whole.hvx" --rays "$out/engine.rays" -o "$out/whole.hits" --device cpu --quiet
    say 'the ray-tracing pipeline'
  fi
  cell cells "$name.octants-groups" "$gpu_day" measure --rays "$out/rays/$name" --scene "$name, sizes of groups" \
    --label octants --device "$device" --seconds 0.05 --set bounce --set shadow --volume "$out/volumes/$name.octants.hvx" \
    --kernel "$pack/kernels/$of/octants.exact.spv" --group 32 --group 128 --group 256 --at-once
done <"$pack/scenes.txt"
"$gpu_day" table "$out" -o "$out" && cat "$out/table.md"
if is_over; then say 'run it again to go on'; fi
