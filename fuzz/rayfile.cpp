// Fuzzes ray files of both versions: what is read must come back from its own bytes.
#include "FuzzedFile.h"

#include "common/RayFile.h"

#include <cstdlib>
#include <cstring>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::span<const std::byte> bytes(reinterpret_cast<const std::byte *>(data), size);
  const auto file = voxc::tool::parseRayFile(bytes, "rays");
  if (!file)
    return 0;
  const voxc::RaySpan rays = file->rays();
  std::vector<voxc::BoundedRay> bounded;
  for (std::size_t i = 0; i < rays.size(); ++i)
    bounded.push_back(voxc::bounded(rays[i], rays.bounds(i)));
  const std::string text = voxc::tool::rayFileText(bounded);
  const auto again = voxc::tool::parseRayFile(std::as_bytes(std::span(text)), "its own bytes");
  if (!again || again->rays().size() != rays.size())
    std::abort();
  if (!bounded.empty() &&
      std::memcmp(again->rays().bytes().data(), bounded.data(), bounded.size() * sizeof bounded[0]) != 0)
    std::abort();
  return 0;
}
