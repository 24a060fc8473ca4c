// What passes ask of the level IR.
#pragma once

#include "voxc/IR/Format.h"
#include "voxc/Support/PassManager.h"

namespace voxc {

template <> struct IrTraits<Format> {
  static constexpr std::string_view kName = "format";
  static void verify(const Format &format, Diagnostics &diagnostics) { voxc::verify(format, diagnostics); }
  static std::string print(const Format &format) { return printIr(format); }
  /// The levels that differ; all where there are more of them or less.
  static std::vector<SourceRange> changedParts(const Format &before, const Format &after);
  static Error errorAt(const Format &format, const Diagnostics &diagnostics);
};

} // namespace voxc
