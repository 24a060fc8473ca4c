// Each level from the one below, in whole numbers.
#include "Mesh/Voxelize/TextureMeans.h"

#include "Support/Srgb.h"

#include <algorithm>

namespace voxc {

namespace {

TextureMeans::Light lightOf(std::uint32_t texel, bool isOpaque) {
  const double alpha = isOpaque ? 65535 : (texel >> 24) * 257;
  return {kLinearLight[texel & 255] * alpha, kLinearLight[texel >> 8 & 255] * alpha,
          kLinearLight[texel >> 16 & 255] * alpha, alpha};
}

/// Texels a side of the cell `index` of a level, of which a texture of `size` may have a part only.
double sideOf(int level, int index, int size) {
  const std::int64_t low = std::int64_t{index} << level;
  return static_cast<double>(std::clamp<std::int64_t>(size - low, 0, std::int64_t{1} << level));
}

bool hasAlpha(const Texture &texture) {
  const auto texels = texture.texels->span();
  return std::ranges::any_of(texels, [](std::uint32_t texel) { return texel >> 24 != 255; });
}

} // namespace

Expected<TextureMeans> TextureMeans::of(const Texture &texture, bool isOpaque,
                                        const std::shared_ptr<WorkingMemory> &memory,
                                        const Progress &progress) {
  TextureMeans means(texture, isOpaque);
  for (int level = 0; (std::int64_t{1} << level) < std::max(texture.width, texture.height); ++level) {
    auto next = VOXC_TRY(means.above(level, memory, progress));
    means.levels_.push_back(std::move(next));
  }
  return means;
}

TextureMeans::Light TextureMeans::cell(int level, std::uint64_t x, std::uint64_t y) const {
  if (level == 0)
    return lightOf((*texture_->texels)[y * static_cast<std::uint64_t>(texture_->width) + x], isOpaque_);
  const Level &of = levels_[static_cast<std::size_t>(level - 1)];
  const Cell &stored = of.cells[y * static_cast<std::uint64_t>(of.width) + x];
  return {double(stored[0]), double(stored[1]), double(stored[2]), double(stored[3])};
}

void TextureMeans::addRow(int level, std::uint64_t y, std::span<const Column> columns, double weight,
                          Light &sum) const {
  Light row{};
  if (level == 0) {
    for (const Column &column : columns) {
      const Light light = cell(0, column.cell, y);
      for (std::size_t i = 0; i < row.size(); ++i)
        row[i] += column.weight * light[i];
    }
  } else {
    const Level &of = levels_[static_cast<std::size_t>(level - 1)];
    const Cell *cells = of.cells.data() + y * static_cast<std::uint64_t>(of.width);
    for (const Column &column : columns)
      for (std::size_t i = 0; i < row.size(); ++i)
        row[i] += column.weight * cells[column.cell][i];
  }
  for (std::size_t i = 0; i < row.size(); ++i)
    sum[i] += weight * row[i];
}

/// The mean of up to four cells of a level, by the texels that they have.
TextureMeans::Cell TextureMeans::meanOf(int level, int x, int y) const {
  Light sum{};
  double texels = 0;
  for (int row = 2 * y; row < 2 * y + 2; ++row)
    for (int column = 2 * x; column < 2 * x + 2; ++column) {
      const double weight = sideOf(level, column, width()) * sideOf(level, row, height());
      if (weight == 0)
        continue;
      texels += weight;
      const Light part = cell(level, static_cast<std::uint64_t>(column), static_cast<std::uint64_t>(row));
      for (std::size_t i = 0; i < sum.size(); ++i)
        sum[i] += part[i] * weight;
    }
  Cell mean;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double raised = sum[i] / texels + 0.5; // std::lround is a call.
    mean[i] = static_cast<std::uint16_t>(raised);
  }
  return mean;
}

Expected<TextureMeans::Level> TextureMeans::above(int level, const std::shared_ptr<WorkingMemory> &memory,
                                                  const Progress &progress) const {
  const auto half = [&](int size) { return static_cast<int>(((size - 1) >> (level + 1)) + 1); };
  Level next{half(width()), half(height()), ScratchArray<Cell>(memory)};
  if (auto sized =
          next.cells.resize(static_cast<std::uint64_t>(next.width) * static_cast<std::uint64_t>(next.height));
      !sized)
    return sized.error();
  Cell *cells = next.cells.data();
  for (int y = 0; y < next.height; ++y) {
    if (progress.stopped())
      return Error::interrupted();
    for (int x = 0; x < next.width; ++x)
      *cells++ = meanOf(level, x, y);
    memory->relieve(static_cast<std::uint64_t>(next.width) * 4 * sizeof(Cell));
  }
  return next;
}

Expected<SceneMeans> SceneMeans::of(const TriangleScene &scene, const std::shared_ptr<WorkingMemory> &memory,
                                    const Progress &progress) {
  SceneMeans means;
  means.means_.resize(scene.textures.size());
  for (const MeshPart &part : scene.parts) {
    const Material &material = scene.materials[part.material];
    const bool isOpaque = material.alpha == AlphaRule::Opaque;
    if (part.uvs)
      VOXC_TRY(means.add(scene, material.texture.texture, isOpaque, memory, progress));
    if (part.emissionUvs)
      VOXC_TRY(means.add(scene, material.emissionTexture.texture, true, memory, progress));
  }
  return means;
}

Expected<void> SceneMeans::add(const TriangleScene &scene, int texture, bool isOpaque,
                               const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  if (texture < 0 || find(texture, isOpaque))
    return {};
  const Texture &of = scene.textures[static_cast<std::size_t>(texture)];
  auto &means = means_[static_cast<std::size_t>(texture)][isOpaque];
  means = VOXC_TRY(TextureMeans::of(of, isOpaque || !hasAlpha(of), memory, progress));
  return {};
}

const TextureMeans *SceneMeans::find(int texture, bool isOpaque) const {
  if (texture < 0 || static_cast<std::size_t>(texture) >= means_.size())
    return nullptr;
  const auto &means = means_[static_cast<std::size_t>(texture)][isOpaque];
  return means ? &*means : nullptr;
}

} // namespace voxc
