// Collecting diagnostics and rendering them with the line and carets.
#include "voxc/Support/Diagnostic.h"

#include <algorithm>

namespace voxc {
namespace {

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

/// Of a long line what is around the range: a hostile text may be one line, and wrong everywhere.
Line shownOf(const Line &line, std::string_view text, SourceRange range) {
  constexpr std::size_t kMostShown = 400;
  Line shown = line;
  if (line.end - line.begin <= kMostShown)
    return shown;
  if (range.begin - line.begin > kMostShown / 2)
    shown.begin = range.begin - kMostShown / 2;
  while (shown.begin < range.begin && (static_cast<unsigned char>(text[shown.begin]) & 0xc0) == 0x80)
    ++shown.begin; // Not in the middle of a character.
  shown.end = std::min(line.end, shown.begin + kMostShown);
  return shown;
}

/// Blanks below the text before the range, then a caret below each of its characters.
std::string carets(std::string_view text, const Line &line, SourceRange range) {
  std::string result;
  for (std::size_t i = line.begin; i < range.begin; ++i)
    result += text[i] == '\t' ? '\t' : ' ';
  const std::size_t end = std::min(range.end, line.end);
  result.append(std::max<std::size_t>(end > range.begin ? end - range.begin : 0, 1), '^');
  return result;
}

/// Nobody reads more, and a hostile text may have millions.
constexpr std::size_t kMostKept = 50;

} // namespace

void Diagnostics::error(SourceRange range, std::string message) {
  if (all_.size() < kMostKept || !hasErrors())
    all_.push_back({Severity::Error, range, std::move(message)});
  else if (all_.size() == kMostKept)
    all_.push_back({Severity::Note, range, "there are more errors from here on"});
}

void Diagnostics::note(SourceRange range, std::string message) {
  if (all_.size() < kMostKept)
    all_.push_back({Severity::Note, range, std::move(message)});
}

bool Diagnostics::hasErrors() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Diagnostic &diagnostic) { return diagnostic.severity == Severity::Error; });
}

std::string render(const Diagnostic &diagnostic, const SourceText &source) {
  const std::string_view text = source.text;
  SourceRange range = diagnostic.range;
  range.begin = std::min(range.begin, text.size());
  const Line line = lineAt(text, range.begin);
  const Line shown = shownOf(line, text, range);
  return source.name + ':' + std::to_string(line.number + source.firstLine - 1) + ':' +
         std::to_string(range.begin - line.begin + 1) + ": " + std::string(toString(diagnostic.severity)) +
         ": " + diagnostic.message + "\n  " + std::string(text.substr(shown.begin, shown.end - shown.begin)) +
         "\n  " + carets(text, shown, range) + '\n';
}

std::string render(const Diagnostics &diagnostics, const SourceText &source) {
  std::string result;
  for (const Diagnostic &diagnostic : diagnostics.all())
    result += render(diagnostic, source);
  return result;
}

std::string render(const Diagnostics &diagnostics, std::string_view text, std::string_view name) {
  return render(diagnostics, SourceText{std::string(name), std::string(text)});
}

std::size_t lineOf(const SourceText &source, std::size_t offset) {
  return lineAt(source.text, std::min(offset, source.text.size())).number + source.firstLine - 1;
}

Error toError(const Diagnostics &diagnostics, const SourceText &source) {
  std::string message = render(diagnostics, source);
  if (!message.empty())
    message.pop_back();
  return Error::input(std::move(message));
}

Error toError(const Diagnostics &diagnostics, std::string_view text, std::string_view name) {
  return toError(diagnostics, SourceText{std::string(name), std::string(text)});
}

} // namespace voxc
