// Texts of materials, each with a place in a table.
#include "Input/MagicaVoxel/VoxMaterial.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace voxc {

namespace {

struct LookRow {
  std::string_view type; ///< As it stands in the file.
  VoxLook look;
};

constexpr std::array<LookRow, 6> kLooks{{{"_diffuse", VoxLook::Diffuse},
                                         {"_metal", VoxLook::Metal},
                                         {"_glass", VoxLook::Glass},
                                         {"_blend", VoxLook::Glass},
                                         {"_emit", VoxLook::Emission},
                                         {"_media", VoxLook::Cloud}}};

constexpr double kMostLight = 1e6;

} // namespace

struct VoxMaterial::Row {
  std::string_view key;
  std::optional<double> VoxMaterial::*number;
  double most;
};

const VoxMaterial::Row VoxMaterial::kRows[]{
    {"_rough", &VoxMaterial::rough_, 1},        {"_metal", &VoxMaterial::metal_, 1},
    {"_emit", &VoxMaterial::emit_, kMostLight}, {"_flux", &VoxMaterial::flux_, kMostLight},
    {"_trans", &VoxMaterial::trans_, 1},        {"_alpha", &VoxMaterial::alpha_, 1},
    {"_weight", &VoxMaterial::weight_, 1}};

void VoxMaterial::read(std::string_view key, std::string_view value) {
  if (key == "_type")
    if (const auto *row = std::ranges::find(kLooks, value, &LookRow::type); row != kLooks.end())
      look_ = row->look;
  const auto *const row = std::ranges::find(kRows, key, &Row::key);
  if (row == std::end(kRows))
    return;
  double number = -1;
  std::from_chars(value.data(), value.data() + value.size(), number);
  if (number >= 0 && number <= row->most)
    this->*row->number = number;
}

void VoxMaterial::keep(VoxFile &file, std::uint32_t number) const {
  const auto firstOf = [](auto... numbers) {
    std::optional<double> first;
    ((first = first ? first : numbers), ...);
    return first;
  };
  if (look_)
    file.looks[number] = *look_;
  file.roughness[number] = static_cast<float>(rough_.value_or(1));
  file.metallic[number] = static_cast<float>(firstOf(metal_, weight_).value_or(0));
  file.clear[number] = static_cast<float>(firstOf(trans_, alpha_, weight_).value_or(0));
  // As importers have it: the power counts from 0.
  file.light[number] = static_cast<float>(firstOf(emit_, weight_).value_or(1) * (1 + flux_.value_or(0)));
}

} // namespace voxc
