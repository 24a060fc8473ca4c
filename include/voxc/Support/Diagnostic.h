// Diagnostics: messages about a text, each with the range of characters it speaks of.
#pragma once

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
};

enum class Severity { Error, Warning, Note };

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

/// The rendered diagnostics as one input error.
Error toError(const Diagnostics &diagnostics, std::string_view text, std::string_view name);

} // namespace voxc
