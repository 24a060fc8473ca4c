// Lines are broken at blanks, behind a comma if one is near, before an operator else; comments among words.
#include "Glsl/Wrap.h"

#include <algorithm>
#include <array>

namespace voxc::glsl {
namespace {

std::size_t indentOf(std::string_view line) { return std::min(line.find_first_not_of(' '), line.size()); }

/// Where a comment is broken: at its last blank that fits, or npos.
std::size_t breakOfComment(std::string_view line, std::size_t least) {
  const std::size_t blank = line.rfind(' ', kMostColumns);
  return blank == std::string_view::npos || blank <= least ? std::string_view::npos : blank;
}

/// Where code is broken: behind the last comma that fits, or before the last operator, or npos.
std::size_t breakOfCode(std::string_view line, std::size_t least) {
  constexpr std::array<std::string_view, 8> kOperators{" && ", " || ", " ? ", " : ",
                                                       " | ",  " + ",  " - ", " * "};
  std::size_t comma = std::string_view::npos, before = std::string_view::npos;
  for (std::size_t at = least + 1; at < line.size() && at <= kMostColumns; ++at) {
    if (line[at] != ' ')
      continue;
    if (line[at - 1] == ',')
      comma = at;
    else if (std::ranges::any_of(kOperators,
                                 [&](std::string_view sign) { return line.substr(at).starts_with(sign); }))
      before = at;
  }
  const bool isCommaNear =
      comma != std::string_view::npos && (before == std::string_view::npos || comma > before / 2);
  return isCommaNear ? comma : before;
}

/// Breaks a line, and what is left of it, until all fits.
void add(std::string &text, std::string line) {
  const std::size_t indent = indentOf(line);
  const bool isComment = std::string_view(line).substr(indent).starts_with("//");
  const std::string next = std::string(indent, ' ') + (isComment ? "// " : "    ");
  for (std::size_t least = indent; line.size() > kMostColumns; least = next.size()) {
    const std::size_t at = isComment ? breakOfComment(line, least + 3) : breakOfCode(line, least);
    if (at == std::string::npos)
      break;
    text.append(line, 0, at).append("\n");
    line.replace(0, at + 1, next);
  }
  text += line + "\n";
}

/// Code without a comment. A function in a line becomes one of three.
void addCode(std::string &text, std::string_view line) {
  const std::size_t open = line.find(" { ");
  if (line.size() <= kMostColumns || line.starts_with(' ') || open == std::string_view::npos ||
      !line.ends_with(" }"))
    return add(text, std::string(line));
  add(text, std::string(line.substr(0, open + 2)));
  add(text, "  " + std::string(line.substr(open + 3, line.size() - open - 5)));
  text += "}\n";
}

/// A comment behind code that would not fit goes above.
void addLine(std::string &text, std::string_view line) {
  const std::size_t indent = indentOf(line);
  const std::size_t comment = line.find(" // ");
  if (line.size() <= kMostColumns || comment == std::string_view::npos || comment < indent)
    return addCode(text, line);
  add(text, std::string(indent, ' ') + std::string(line.substr(comment + 1)));
  addCode(text, line.substr(0, line.find_last_not_of(' ', comment) + 1));
}

} // namespace

std::string wrapped(std::string_view text) {
  std::string result;
  bool isDirective = false; // Of the preprocessor, over all its lines.
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    isDirective = isDirective || line.starts_with('#');
    if (isDirective)
      result.append(line).append("\n");
    else
      addLine(result, line);
    isDirective = isDirective && line.ends_with('\\');
  }
  return result;
}

} // namespace voxc::glsl
