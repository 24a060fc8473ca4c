// The languages that functions for others are printed in: a row each.
#pragma once

#include "Glsl/Printer.h"

#include "voxc/Emit/Emit.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

struct HeaderLanguageKind {
  std::string_view extension; ///< Of its file.
  /// The runtime files before the functions and behind them. With forms the first is a folder: of files for
  /// functions with bounds or without, for volumes of which all words are here or some, and for all.
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
  bool hasForms = false;

  /// The files before the functions of a plan.
  std::vector<std::string> filesBefore(const Plan &plan) const;
};

const HeaderLanguageKind &kindOf(HeaderLanguage language);

} // namespace voxc
