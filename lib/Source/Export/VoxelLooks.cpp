// Gathering attributes voxel by voxel.
#include "Source/Export/VoxelLooks.h"

#include "Source/CubeTools.h"
#include "voxc/Volume/Attributes.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <numeric>
#include <string_view>
#include <tuple>

namespace voxc {

namespace {

constexpr std::string_view kEmission = "emission";
constexpr std::string_view kStrength = "emission-strength";
constexpr std::string_view kMetal = "metallic-roughness";

/// The elements of an attribute, 4 bytes each, or none.
class Elements {
public:
  Elements(const Volume &volume, std::string_view name) : stream_(findAttribute(volume, name)) {
    if (stream_ && stream_->elementBytes != sizeof(std::uint32_t))
      stream_ = nullptr;
  }

  explicit operator bool() const { return stream_ != nullptr; }

  template <typename Value> Value at(std::uint64_t number, Value otherwise) const {
    if (stream_)
      std::memcpy(&otherwise, &stream_->bytes[number * sizeof otherwise], sizeof otherwise);
    return otherwise;
  }

private:
  const Stream *stream_;
};

} // namespace

bool VoxelLook::operator<(const VoxelLook &other) const {
  return std::tie(emission, strength, metal) < std::tie(other.emission, other.strength, other.metal);
}

Expected<VoxelLooks> VoxelLooks::of(const Volume &volume, const Progress &progress) {
  VoxelLooks found;
  const Elements emission(volume, kEmission), strength(volume, kStrength), metal(volume, kMetal);
  if (!emission && !metal)
    return found;
  std::map<VoxelLook, std::uint32_t> numbers{{VoxelLook(), 0}};
  const auto visit = [&](Int3 voxel, std::uint64_t number) {
    VoxelLook look;
    look.emission = emission.at(number, std::uint32_t{0});
    look.emission = (look.emission & 0xffffff) == 0 ? 0 : look.emission | 0xff000000;
    if (const float times = strength.at(number, 1.0F); look.emission != 0 && times >= 0)
      look.strength = std::min(times, 1e30F);
    look.metal = metal.at(number, std::uint32_t{0});
    look.metal = look.metal == 0 ? 0 : look.metal | 0xff000000;
    const auto [entry, isNew] = numbers.try_emplace(look, static_cast<std::uint32_t>(found.looks_.size()));
    if (isNew)
      found.looks_.push_back(look);
    if (entry->second != 0) {
      found.codes_.push_back(mortonCode(voxel));
      found.numbers_.push_back(entry->second);
    }
    return true;
  };
  VOXC_TRY(visitVoxels(volume, visit, progress));
  if (!std::ranges::is_sorted(found.codes_))
    found.sort();
  return found;
}

void VoxelLooks::sort() {
  std::vector<std::size_t> order(codes_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return codes_[i]; });
  VoxelLooks sorted;
  for (const std::size_t i : order) {
    sorted.codes_.push_back(codes_[i]);
    sorted.numbers_.push_back(numbers_[i]);
  }
  codes_ = std::move(sorted.codes_);
  numbers_ = std::move(sorted.numbers_);
}

VoxelLooks::Range VoxelLooks::between(std::uint64_t begin, std::uint64_t end) const {
  const auto first = std::ranges::lower_bound(codes_, begin);
  const auto last = std::lower_bound(first, codes_.end(), end);
  const auto at = static_cast<std::size_t>(first - codes_.begin());
  const auto count = static_cast<std::size_t>(last - first);
  return {std::span(codes_).subspan(at, count), std::span(numbers_).subspan(at, count)};
}

std::uint32_t VoxelLooks::at(std::uint64_t code) const {
  const Range found = between(code, code + 1);
  return found.looks.empty() ? 0 : found.looks.front();
}

std::string attributesLeftOut(const Volume &volume, bool holdsLooks, const std::string &ending) {
  constexpr std::array<std::string_view, 3> kLooks{kEmission, kStrength, kMetal};
  const bool hasEmission = bool(Elements(volume, kEmission));
  const auto isLook = [&](const Stream &stream) {
    return std::ranges::find(kLooks, stream.name) != kLooks.end() && Elements(volume, stream.name) &&
           (stream.name != kStrength || hasEmission);
  };
  std::string names;
  for (const Stream &stream : volume.streams())
    if (stream.name != kWordStream && !(holdsLooks && isLook(stream)))
      names += (names.empty() ? "'" : ", '") + stream.name + "'";
  return names.empty()
             ? std::string()
             : "a " + ending + " file has no place for these attributes, which are left out: " + names;
}

} // namespace voxc
