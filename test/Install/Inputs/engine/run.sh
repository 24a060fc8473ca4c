# run.sh ENGINE FOLDER VOXC PYTHON COMPARE: runs the engine, and compares its answers with those of voxc.
if ! "$1" "$2/chunks" "$2/frame" 160 90 > "$2/said" 2>&1; then
  cat "$2/said"
  grep -q 'no Vulkan device here has VK_KHR_ray_tracing_pipeline' "$2/said"
  exit
fi
cat "$2/said"
"$3" trace "$2/chunks/whole.hvx" --rays "$2/frame.rays" -o "$2/whole.hits" --device cpu --quiet
"$4" "$5" "$2/frame" "$2/whole.hits"
