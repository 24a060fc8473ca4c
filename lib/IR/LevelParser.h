// What format strings and IR text share: a level's parameters in parentheses, and that the text is kept.
#pragma once

#include "Lexer.h"

#include "voxc/IR/Format.h"

#include <optional>

namespace voxc {

/// One parameter as written; of "4^3", three.
struct Argument {
  std::uint32_t value;
  SourceRange range;
};

/// Parses '(' numbers ')' and, for grids, "N^3". After an error the tokens up to the ')' are skipped, and
/// nothing is returned.
std::optional<std::vector<Argument>> parseArguments(Lexer &lexer, Diagnostics &diagnostics);

/// Checks the count against the kind's parameters and sets them. `head` is the range of the level's name.
bool setParameters(Level &level, const std::vector<Argument> &arguments, SourceRange head,
                   Diagnostics &diagnostics);

/// False, and an error, of a text longer than 1 MiB, which no format needs.
bool checkTextSize(std::string_view text, Diagnostics &diagnostics);

/// The text for `Format::source`.
std::shared_ptr<const SourceText> keepSource(std::string_view text, std::string_view name = "format");

/// How a kind is written: "R(W, H, D)".
std::string signature(const LevelKind &kind);

} // namespace voxc
