// Reading expectations from comments, and comparing them with what was found.
#include "ExpectedDiagnostics.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

namespace voxc::tool {
namespace {

constexpr std::string_view kHead = "expected-";
constexpr std::string_view kAbove = "above", kBelow = "below";

/// Where the comment of a line begins: at a '//' that stands in no quotation marks.
std::size_t commentOf(std::string_view line) {
  bool isQuoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    isQuoted = isQuoted != (line[i] == '"');
    if (!isQuoted && line.substr(i, 2) == "//")
      return i;
  }
  return line.size();
}

/// Takes a word from the front of a text, if it stands there.
bool take(std::string_view &text, std::string_view word) {
  if (!text.starts_with(word))
    return false;
  text.remove_prefix(word.size());
  return true;
}

void skipBlanks(std::string_view &text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
}

std::optional<Severity> takeSeverity(std::string_view &text) {
  for (const std::string_view name : kEnumNames<Severity>)
    if (take(text, name))
      return fromString<Severity>(name);
  return {};
}

} // namespace

/// Goes through the lines of a text.
class ExpectationReader {
public:
  explicit ExpectationReader(const SourceText &source)
      : source_(source), number_(source.firstLine), result_(source) {}

  Expected<ExpectedDiagnostics> read() {
    const std::string_view text = source_.text;
    for (std::size_t begin = 0; begin < text.size(); ++number_) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      readLine(text.substr(begin, end - begin), begin);
      begin = end + 1;
    }
    if (diagnostics_.hasErrors())
      return toError(diagnostics_, source_);
    return std::move(result_);
  }

private:
  void readLine(std::string_view line, std::size_t begin) {
    const std::size_t before = result_.expected_.size();
    std::size_t at = commentOf(line);
    while ((at = line.find(kHead, at)) != std::string_view::npos) {
      std::string_view rest = line.substr(at + kHead.size());
      if (const auto severity = takeSeverity(rest))
        readExpectation(*severity, rest, begin + at);
      at = line.size() - rest.size();
    }
    if (result_.expected_.size() > before)
      return;
    for (std::size_t waiting : below_)
      result_.expected_[waiting].line = number_;
    below_.clear();
    lastPlain_ = number_;
  }

  /// What follows "expected-error": where, and what.
  void readExpectation(Severity severity, std::string_view &rest, std::size_t begin) {
    const std::size_t lineEnd = std::min(source_.text.find('\n', begin), source_.text.size());
    skipBlanks(rest);
    std::size_t line = number_;
    const bool isPlaced = !take(rest, "@") || takePlace(rest, line);
    skipBlanks(rest);
    const std::size_t end = rest.find("}}");
    if (!isPlaced || !take(rest, "{{") || end == std::string_view::npos) {
      diagnostics_.error({begin, lineEnd},
                         "found an expectation that cannot be read; write such as 'expected-" +
                             std::string(toString(severity)) +
                             " @+1 {{a part of the message}}', with @+N, @-N, @above, @below or nothing");
      return;
    }
    const std::string_view text = rest.substr(0, end - 2);
    rest.remove_prefix(end);
    result_.expected_.push_back({severity, line, std::string(text), {begin, lineEnd - rest.size()}});
  }

  /// Above and below are the nearest lines without expectations.
  bool takePlace(std::string_view &rest, std::size_t &line) {
    if (take(rest, kBelow)) {
      below_.push_back(result_.expected_.size());
      return true;
    }
    if (take(rest, kAbove)) {
      line = lastPlain_;
      return true;
    }
    const bool isBefore = rest.starts_with('-');
    if (!isBefore && !rest.starts_with('+'))
      return false;
    std::size_t distance = 0;
    const auto [end, problem] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), distance);
    if (problem != std::errc())
      return false;
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    line = isBefore ? line - distance : line + distance;
    return true;
  }

  const SourceText &source_;
  std::size_t number_;
  std::size_t lastPlain_ = 0;
  std::vector<std::size_t> below_; ///< Expectations of the next line without any.
  ExpectedDiagnostics result_;
  Diagnostics diagnostics_;
};

Expected<ExpectedDiagnostics> ExpectedDiagnostics::read(const SourceText &source) {
  return ExpectationReader(source).read();
}

Expected<void> ExpectedDiagnostics::compare(std::span<const Diagnostic> found) const {
  std::vector<bool> isMet(expected_.size());
  Diagnostics wrong;
  for (const Diagnostic &diagnostic : found) {
    const std::size_t line = lineOf(source_, diagnostic.range.begin);
    std::size_t i = 0;
    while (i < expected_.size() &&
           (isMet[i] || expected_[i].severity != diagnostic.severity || expected_[i].line != line ||
            diagnostic.message.find(expected_[i].text) == std::string::npos))
      ++i;
    if (i < expected_.size())
      isMet[i] = true;
    else
      wrong.error(diagnostic.range,
                  "unexpected " + std::string(toString(diagnostic.severity)) + ": " + diagnostic.message);
  }
  for (std::size_t i = 0; i < expected_.size(); ++i)
    if (!isMet[i])
      wrong.error(expected_[i].range, "expected " + std::string(toString(expected_[i].severity)) + " \"" +
                                          expected_[i].text + "\" on line " +
                                          std::to_string(expected_[i].line) + " was not produced");
  if (wrong.hasErrors())
    return toError(wrong, source_);
  return {};
}

} // namespace voxc::tool
