// The languages that functions for others are printed in: a row each.
#pragma once

#include "Glsl/Printer.h"

#include "voxc/Emit/Emit.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace voxc {

struct HeaderLanguageKind {
  std::string_view extension; ///< Of its file.
  /// The runtime files before the functions and behind them.
  std::string_view begin;
  std::string_view end;
  /// The type of a volume, which all functions that load words hand on.
  std::string_view volume;
  /// `prefix`: that of all names.
  std::unique_ptr<glsl::Printer> (*printer)(const std::string &prefix);
  /// What the module has to become; null: it stays as it is.
  void (*makeReady)(glsl::Module &module) = nullptr;
  /// The runtime files of functions that GLSL has and this language has not.
  std::span<const std::string_view> lacking = {};
  /// It has a way to keep sums from being put in another order, so that rays from far away come near.
  bool keepsSums = true;
};

const HeaderLanguageKind &kindOf(HeaderLanguage language);

} // namespace voxc
