// The words of GLSL, each with the comments around it.
#pragma once

#include "voxc/Support/Error.h"

#include "Glsl/Tree.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc::glsl {

struct Token {
  enum class Kind { Word, Number, Sign, Directive, End };

  Kind kind = Kind::End;
  std::string text = {}; ///< A directive without what continues its line.
  Notes notes = {};      ///< Comments that end the token's line are behind it.
  int line = 0;          ///< From 1.

  bool is(std::string_view other) const { return text == other && kind != Kind::Directive; }
};

/// The tokens of a text, and one of kind End behind them, which has the comments that are left. Signs are as
/// long as they can be: "<<=" is one. Error: a character that no token begins with, and in which line.
Expected<std::vector<Token>> tokensOf(std::string_view text);

} // namespace voxc::glsl
