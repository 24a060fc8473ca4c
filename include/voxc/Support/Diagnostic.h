// Diagnostics: messages about a text, each with the range of characters it speaks of.
#pragma once

#include "voxc/Support/EnumText.h"
#include "voxc/Support/Error.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// Half-open range of byte offsets into a source text.
struct SourceRange {
  std::size_t begin = 0;
  std::size_t end = 0;

  bool operator==(const SourceRange &) const = default;
};

/// A text that diagnostics may speak of, and what they call it: the name of a file, or of an argument.
struct SourceText {
  std::string name;
  std::string text;
  std::size_t firstLine = 1; ///< The number of its first line, where it is a part of a file.
};

enum class Severity { Error, Warning, Remark, Note };
template <>
inline constexpr std::array<std::string_view, 4> kEnumNames<Severity> = {"error", "warning", "remark",
                                                                         "note"};

/// One sentence about one range of a text, lower case, saying what was found and what would be right.
struct Diagnostic {
  Severity severity = Severity::Error;
  SourceRange range;
  std::string message;
};

/// The diagnostics of one text, in the order in which they were found.
class Diagnostics {
public:
  void error(SourceRange range, std::string message);
  void note(SourceRange range, std::string message);

  bool hasErrors() const;
  const std::vector<Diagnostic> &all() const { return all_; }

private:
  std::vector<Diagnostic> all_;
};

/// Renders each diagnostic as `name:line:column: error: message`, followed by the line it speaks of and a
/// line with carets under the whole range. Columns count from 1; tabs are kept so that the carets line up.
std::string render(const Diagnostics &diagnostics, std::string_view text, std::string_view name);
std::string render(const Diagnostics &diagnostics, const SourceText &source);
std::string render(const Diagnostic &diagnostic, const SourceText &source);

/// The number of the line of a text in which an offset lies.
std::size_t lineOf(const SourceText &source, std::size_t offset);

/// The rendered diagnostics as one input error.
Error toError(const Diagnostics &diagnostics, const SourceText &source);
Error toError(const Diagnostics &diagnostics, std::string_view text, std::string_view name);

} // namespace voxc
