// The leaves of a kernel: runtime files, read, specialised and put one behind the other.
#pragma once

#include "Emit/FormatWords.h"

#include "Glsl/Passes.h"
#include "Glsl/Tree.h"

#include "voxc/Plan/Plan.h"
#include "voxc/Support/Error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace voxc {

/// Collects what a kernel of a plan is made of, in order of use: a function stands before its callers.
class KernelBuilder {
public:
  explicit KernelBuilder(const Plan &plan, FormatWords words = {});

  const Plan &plan() const { return plan_; }
  /// Further constants of leaves, for those of all levels.
  void define(std::string_view name, std::string value) { constants_[std::string(name)] = std::move(value); }

  /// A file of shaders-runtime, by its path without ".glsl". In it `f_lowest` is f of the level of voxels.
  void add(std::string_view path);
  /// One that is written for a level, by names of its own. In it `f_level` is the level's f, `f_next` that of
  /// the next one, or of a voxel, and LEVEL_SIZE the level's SIZE.
  void addLevel(std::string_view path, std::size_t index);
  /// One that is written for a layer of a level: 1, whose nodes have cells for children, to its depth. In it
  /// `f_level_layer` is the layer's f, and `f_level_lower` that of the layer below. In files of levels
  /// `f_level_highest` is that of the root.
  void addLayer(std::string_view path, std::size_t index, int layer);
  /// What is added from here on is what the format brings, or no longer.
  void beginFormat() { isOfFormat_ = true; }
  void endFormat() { isOfFormat_ = false; }
  /// Text that emitters make themselves, with an empty line before it if it stands apart.
  void addText(std::string_view text, bool isApart = true);

  /// The module, with the constants of the plan put in, and without what nothing from `roots` on comes to.
  /// Error: what is wrong of a file.
  Expected<glsl::Module> specialised(const glsl::Names &roots) &&;

private:
  glsl::Module read(std::string_view path);
  glsl::Module parsed(std::string_view name, std::string_view text);
  void append(glsl::Module module, bool isApart = true);

  const Plan &plan_;
  FormatWords words_;
  glsl::Constants constants_;
  glsl::Module module_;
  bool isOfFormat_ = false;
  std::optional<Error> problem_;
};

} // namespace voxc
