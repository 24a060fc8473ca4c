// Means of texels over squares of 2, 4, 8 ... a side, in linear light.
#pragma once

#include "voxc/Mesh/TriangleScene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace voxc {

/// A texture with its means. Colours count by their alpha, but in one that is opaque, whose alpha means
/// nothing. The texture must outlive this.
class TextureMeans {
public:
  /// Red, green and blue as linear light multiplied by alpha, then alpha, of 65535.
  using Light = std::array<double, 4>;

  /// Errors: interrupted, no memory.
  static Expected<TextureMeans> of(const Texture &texture, bool isOpaque,
                                   const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

  int width() const { return texture_->width; }
  int height() const { return texture_->height; }
  /// Levels of means; the last has one cell.
  int levels() const { return static_cast<int>(levels_.size()); }
  /// A column of cells, and how much it counts.
  struct Column {
    std::uint64_t cell;
    double weight;
  };
  /// Adds the cells of a row, each times its column's weight and `weight`, to `sum`.
  void addRow(int level, std::uint64_t y, std::span<const Column> columns, double weight, Light &sum) const;

  /// The mean over the square with this index of a level, 2^`level` texels a side, or what the texture has of
  /// it. Level 0 is the texels.
  Light cell(int level, std::uint64_t x, std::uint64_t y) const;

private:
  using Cell = std::array<std::uint16_t, 4>; ///< The same, rounded.
  struct Level {
    int width;
    int height;
    ScratchArray<Cell> cells;
  };

  TextureMeans(const Texture &texture, bool isOpaque) : texture_(&texture), isOpaque_(isOpaque) {}
  Expected<Level> above(int level, const std::shared_ptr<WorkingMemory> &memory,
                        const Progress &progress) const;
  Cell meanOf(int level, int x, int y) const;

  const Texture *texture_;
  bool isOpaque_;
  std::vector<Level> levels_; ///< From level 1 on.
};

/// The means of all textures that colour surfaces of a scene.
class SceneMeans {
public:
  /// Of the textures that parts with coordinates use. The scene must outlive this. Errors: interrupted, no
  /// memory.
  static Expected<SceneMeans> of(const TriangleScene &scene, const std::shared_ptr<WorkingMemory> &memory,
                                 const Progress &progress);

  /// The means of a texture, or null if there are none.
  const TextureMeans *find(int texture, bool isOpaque) const;

private:
  Expected<void> add(const TriangleScene &scene, int texture, bool isOpaque,
                     const std::shared_ptr<WorkingMemory> &memory, const Progress &progress);

  /// By texture, first those by alpha.
  std::vector<std::array<std::optional<TextureMeans>, 2>> means_;
};

} // namespace voxc
