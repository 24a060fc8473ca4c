// Fuzzes the structure check, lookups and decoding: a format's text up to a line feed, then words.
#include "FuzzedFile.h"
#include "VolumeUse.h"
#include "WordMutator.h"

#include <algorithm>
#include <utility>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::string_view text = voxc::fuzz::textOf(data, size);
  const std::size_t end = std::min(text.find('\n'), text.size());
  const auto format = voxc::parseFormat(text.substr(0, end));
  if (!format)
    return 0;
  const std::string_view rest = text.substr(std::min(end + 1, text.size()));
  std::vector<std::uint32_t> words(rest.size() / 4);
  std::copy_n(rest.data(), words.size() * 4, reinterpret_cast<char *>(words.data()));
  const auto voxels = voxc::checkStructure(*format, words);
  if (!voxels)
    return 0;
  voxc::VolumeInfo info;
  info.format = *format;
  info.extent = format->extent();
  info.voxels = *voxels;
  voxc::fuzz::decodeAll(voxc::Volume(std::move(info), std::move(words)));
  return 0;
}
