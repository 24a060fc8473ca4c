// The leaves of a kernel: runtime files, read, specialised and put one behind the other.
#pragma once

#include "Names.h"

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
  explicit KernelBuilder(const Plan &plan) : plan_(plan), names_(planNames(plan)) {}

  const Plan &plan() const { return plan_; }
  /// What files speak of, to which emitters add.
  TemplateNames &names() { return names_; }

  /// A file of shaders-runtime, by its path without ".glsl".
  void add(std::string_view path) { add(path, names_); }
  /// One that is written for a level, by names of its own. In it `f_level` is the level's f, `f_next` that of
  /// the next one, or of a voxel, and LEVEL_SIZE the level's SIZE.
  void addLevel(std::string_view path, std::size_t index, const TemplateNames &names);
  void addLevel(std::string_view path, std::size_t index) {
    addLevel(path, index, stratumNames(plan_, index));
  }
  /// Text that emitters make themselves, with an empty line before it if it stands apart.
  void addText(std::string_view text, bool isApart = true);

  /// The module, with the constants of the plan put in, and without what nothing from `roots` on comes to.
  /// Error: what is wrong of a file.
  Expected<glsl::Module> specialised(const glsl::Names &roots) &&;

private:
  void add(std::string_view path, const TemplateNames &names);
  void append(glsl::Module module, bool isApart = true);
  std::optional<glsl::Module> read(std::string_view name, std::string_view text);

  const Plan &plan_;
  TemplateNames names_;
  glsl::Module module_;
  std::optional<Error> problem_;
};

} // namespace voxc
