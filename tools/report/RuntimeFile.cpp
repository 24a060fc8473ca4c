// The files of report-runtime.
#include "report/RuntimeFile.h"

#include "voxc/Support/EmbeddedFile.h"

namespace voxc {

/// Made by cmake/VoxcEmbed.cmake.
std::span<const EmbeddedFile> reportFiles();

namespace report {

std::string_view runtimeFile(std::string_view path) {
  for (const EmbeddedFile &file : reportFiles())
    if (file.path == path)
      return file.text;
  return {};
}

} // namespace report
} // namespace voxc
