// A format of the C interface, and lists of names.
#pragma once

#include "C/Handles.h"
#include "voxc/IR/Format.h"
#include "voxc/Passes/Pass.h"

#include <voxc-c/voxc.h>

#include <string>
#include <string_view>
#include <vector>

struct voxc_format {
  explicit voxc_format(voxc::Format made)
      : format(std::move(made)), text(toString(format)), ir(printIr(format)) {}

  voxc::Format format;
  std::string text;
  std::string ir;
};

namespace voxc::c {

/// The names of a list with commas between, without blanks around.
inline std::vector<std::string> namesIn(std::string_view list) {
  std::vector<std::string> names;
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    std::string_view name = list.substr(0, comma);
    list.remove_prefix(std::min(comma + 1, list.size()));
    const std::size_t first = name.find_first_not_of(' ');
    if (first != std::string_view::npos)
      names.emplace_back(name.substr(first, name.find_last_not_of(' ') + 1 - first));
  }
  return names;
}

} // namespace voxc::c
