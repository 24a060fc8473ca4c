// Which voxc this is, in words.
#include "voxc/Support/Version.h"

namespace voxc {

std::string versionText() {
  const int numbers[] = {VOXC_VERSION_MAJOR, VOXC_VERSION_MINOR, VOXC_VERSION_PATCH};
  std::string text = "voxc ";
  for (const int number : numbers)
    text += (text.ends_with(' ') ? "" : ".") + std::to_string(number);
  return text;
}

} // namespace voxc
