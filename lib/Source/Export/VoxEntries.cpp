// Materials of MagicaVoxel: light of the own colour, glass, or metal.
#include "Source/Export/VoxEntries.h"

#include "Source/Export/GlbFile.h"
#include "voxc/Volume/LabelColour.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace voxc {

namespace {

constexpr float kMostStrength = 1e6F;

struct VoxMaterial {
  std::vector<std::pair<std::string, std::string>> texts;
  bool isWhole = true; ///< They say all of the look.
};

VoxMaterial lightOf(const VoxelLook &look, std::uint32_t colour) {
  const double strength = std::min(look.strength, kMostStrength);
  const double flux = std::max(std::ceil(strength) - 1, 0.0);
  return {{{"_type", "_emit"}, {"_emit", jsonNumber(strength / (1 + flux))}, {"_flux", jsonNumber(flux)}},
          ((look.emission ^ colour) & 0xffffff) == 0 && isRough(look) && look.strength <= kMostStrength};
}

/// Nothing of what is neither clear, smooth, metallic nor gives off light.
VoxMaterial voxMaterialOf(const VoxelLook &look, std::uint32_t colour) {
  const auto share = [&](unsigned channel) { return jsonNumber((look.metal >> 8 * channel & 255) / 255.0); };
  if (look.emission != 0)
    return lightOf(look, colour);
  if (isRough(look))
    return {};
  if ((look.metal & 255) != 0)
    return {{{"_type", "_glass"}, {"_rough", share(1)}, {"_trans", share(0)}, {"_alpha", share(0)}},
            (look.metal >> 16 & 255) == 0};
  return {{{"_type", "_metal"}, {"_rough", share(1)}, {"_metal", share(2)}}, true};
}

} // namespace

VoxEntries::VoxEntries(const VoxLooksOf &looks) : of_(looks) {
  for (std::uint32_t label = 1; of_.areLabels && label <= kMostVoxEntries; ++label)
    entries_.push_back({labelColour(label)});
}

std::uint32_t VoxEntries::numberOf(std::uint32_t word, std::uint32_t look) {
  if (!of_.areLabels) {
    const auto [number, isNew] =
        numbers_.try_emplace({word, look}, static_cast<std::uint32_t>(entries_.size() + 1));
    if (isNew)
      entries_.push_back({word, look, true});
    return number->second;
  }
  if (word <= entries_.size()) {
    Entry &entry = entries_[word - 1];
    if (!entry.isUsed)
      entry.look = look;
    entry.isUsed = true;
    haveLabelsOneLook_ = haveLabelsOneLook_ && entry.look == look;
  }
  return word;
}

void VoxEntries::addChunks(VoxBytes &children) const {
  VoxBytes palette;
  for (std::size_t i = 0; i < 256; ++i)
    palette.word(i < entries_.size() ? entries_[i].colour : 0);
  children.chunk("RGBA", palette);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const auto texts = voxMaterialOf(of_.looks[entries_[i].look], entries_[i].colour).texts;
    if (texts.empty())
      continue;
    VoxBytes material;
    material.word(static_cast<std::uint32_t>(i + 1)).word(static_cast<std::uint32_t>(texts.size()));
    for (const auto &[key, value] : texts)
      material.string(key).string(value);
    children.chunk("MATL", material);
  }
}

bool VoxEntries::areWhole() const {
  return haveLabelsOneLook_ && std::ranges::all_of(entries_, [&](const Entry &entry) {
           return voxMaterialOf(of_.looks[entry.look], entry.colour).isWhole;
         });
}

} // namespace voxc
