# Writes OUTPUT: a C++ file that holds the files PATHS (separated by '|', below ROOT) as raw string literals.
string(REPLACE "|" ";" paths "${PATHS}")
set(rows "")
foreach(path IN LISTS paths)
  file(READ "${ROOT}/${path}" text)
  # A literal may not be longer than 65536 characters everywhere; runtime files are far smaller.
  string(APPEND rows "    {\"${path}\", R\"voxc-embedded(${text})voxc-embedded\"},\n")
endforeach()
file(WRITE "${OUTPUT}"
"// Generated from the files of ${NAME}.
#include \"voxc/Support/EmbeddedFile.h\"

namespace voxc {

static constexpr EmbeddedFile kFiles[] = {
${rows}};

std::span<const EmbeddedFile> ${NAME}() { return kFiles; }

} // namespace voxc
")
