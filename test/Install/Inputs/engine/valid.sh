# valid.sh SOURCE BUILD: every shader of examples/engine is compiled again, and passed by spirv-val.
for shader in "$1"/*.r* "$2"/voxc_*.rint "$2"/voxc_*.rchit; do
  made="$2/$(basename "$shader").spv"
  glslangValidator -V --target-env vulkan1.2 "-I$1" "-I$2" "$shader" -o "$made" > /dev/null
  spirv-val --target-env vulkan1.2 "$made"
  echo "valid: $made"
done
