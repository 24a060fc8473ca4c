// Collecting diagnostics and rendering them with the line and carets.
#include "voxc/Support/Diagnostic.h"

#include <algorithm>

namespace voxc {
namespace {

std::string_view label(Severity severity) {
  switch (severity) {
  case Severity::Error:
    return "error";
  case Severity::Warning:
    return "warning";
  case Severity::Note:
    return "note";
  }
  return "";
}

/// The line of `text` that an offset lies in.
struct Line {
  std::size_t number = 1;
  std::size_t begin = 0;
  std::size_t end = 0;
};

Line lineAt(std::string_view text, std::size_t offset) {
  Line line;
  line.number += static_cast<std::size_t>(std::count(text.begin(), text.begin() + offset, '\n'));
  const std::size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  line.begin = before == std::string_view::npos ? 0 : before + 1;
  line.end = std::min(text.find('\n', offset), text.size());
  return line;
}

/// What is shown of a longer line, and how much of that stands before what the diagnostic speaks of.
constexpr std::size_t kMostShown = 200, kShownBefore = 60;
constexpr std::string_view kCut = "...";

/// A text may be wrong in more places than anyone reads of, and each is rendered with its line.
constexpr std::size_t kMostDiagnostics = 20;

/// Behind the first diagnostics comes one more, which stands for all others.
void add(std::vector<Diagnostic> &all, Diagnostic diagnostic) {
  if (all.size() == kMostDiagnostics)
    diagnostic.message = "there is more from here on, which is not told";
  if (all.size() <= kMostDiagnostics)
    all.push_back(std::move(diagnostic));
  else if (diagnostic.severity == Severity::Error)
    all.back().severity = Severity::Error;
}

/// The first byte of the character that an offset lies in, which has four bytes at most.
std::size_t characterAt(std::string_view text, std::size_t offset, std::size_t least) {
  least = std::max(least, offset - std::min<std::size_t>(offset, 3));
  while (offset > least && offset < text.size() && (static_cast<unsigned char>(text[offset]) & 0xc0) == 0x80)
    --offset;
  return offset;
}

/// The line, or of a long one what stands around the beginning of the range.
SourceRange shownOf(std::string_view text, const Line &line, SourceRange range) {
  if (line.end - line.begin <= kMostShown)
    return {line.begin, line.end};
  const std::size_t before = std::min(range.begin - line.begin, kShownBefore);
  const std::size_t begin = characterAt(text, range.begin - before, line.begin);
  return {begin, characterAt(text, std::min(begin + kMostShown, line.end), range.begin)};
}

/// The line, and below it blanks before the range, then a caret below each of its characters.
std::string quotedLine(std::string_view text, const Line &line, SourceRange range) {
  const SourceRange shown = shownOf(text, line, range);
  const std::string_view before = shown.begin > line.begin ? kCut : "";
  const std::string_view behind = shown.end < line.end ? kCut : "";
  std::string result = "  ";
  result.append(before).append(text.substr(shown.begin, shown.end - shown.begin)).append(behind);
  result.append("\n  ").append(before.size(), ' ');
  for (std::size_t i = shown.begin; i < range.begin; ++i)
    result += text[i] == '\t' ? '\t' : ' ';
  const std::size_t end = std::min(range.end, shown.end);
  result.append(std::max<std::size_t>(end > range.begin ? end - range.begin : 0, 1), '^');
  return result += '\n';
}

} // namespace

void Diagnostics::error(SourceRange range, std::string message) {
  add(all_, {Severity::Error, range, std::move(message)});
}

void Diagnostics::note(SourceRange range, std::string message) {
  add(all_, {Severity::Note, range, std::move(message)});
}

bool Diagnostics::hasErrors() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Diagnostic &diagnostic) { return diagnostic.severity == Severity::Error; });
}

std::string render(const Diagnostics &diagnostics, std::string_view text, std::string_view name) {
  std::string result;
  for (const Diagnostic &diagnostic : diagnostics.all()) {
    SourceRange range = diagnostic.range;
    range.begin = std::min(range.begin, text.size());
    const Line line = lineAt(text, range.begin);
    result += std::string(name) + ':' + std::to_string(line.number) + ':' +
              std::to_string(range.begin - line.begin + 1) + ": " + std::string(label(diagnostic.severity)) +
              ": " + diagnostic.message + '\n' + quotedLine(text, line, range);
  }
  return result;
}

Error toError(const Diagnostics &diagnostics, std::string_view text, std::string_view name) {
  std::string message = render(diagnostics, text, name);
  if (!message.empty())
    message.pop_back();
  return Error::input(std::move(message));
}

} // namespace voxc
