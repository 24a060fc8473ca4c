// Comparing names of files.
#include "FiguresFile.h"

#include "NumberedName.h"

#include "voxc/Volume/Volume.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace voxc::tool {
namespace {

namespace fs = std::filesystem;

/// A name without links and dots, whether or not the file is there.
std::string wholeName(const std::string &name) {
  std::error_code failure;
  const fs::path whole = fs::weakly_canonical(fs::absolute(name, failure), failure);
  return failure ? name : whole.string();
}

/// What may name a file in what an option was given: it begins at once, or behind a kind or a name, and ends
/// before the number of a frame or a place, or before options of its own.
std::vector<std::string> namesIn(const std::string &written) {
  std::vector<std::string> names;
  for (std::size_t begin = 0; begin != std::string::npos;) {
    for (std::size_t end = begin; end != std::string::npos;) {
      end = written.find_first_of("#@ ", end + 1);
      names.push_back(written.substr(begin, end == std::string::npos ? end : end - begin));
    }
    begin = written.find_first_of(":= ", begin);
    begin += begin == std::string::npos ? 0 : 1;
  }
  std::erase(names, "");
  return names;
}

/// The file that the figures go to.
class FiguresFile {
public:
  explicit FiguresFile(const std::string &name) : name_(name), whole_(wholeName(name)) {}

  const std::string &name() const { return name_; }

  bool isNamedBy(const std::string &written) const {
    return std::ranges::any_of(namesIn(written), [&](const std::string &name) {
      return is(name) || is(journalPathOf(name)) || isOneOf(parseNumberedName(wholeName(name)));
    });
  }

  /// Is it a file, one of a numbered set, or in a folder of this name?
  bool isOf(const std::string &made) const {
    const std::string whole = wholeName(made);
    return is(made) || isOneOf(parseNumberedName(whole)) || whole_.starts_with(whole + "/");
  }

private:
  bool is(const std::string &name) const {
    std::error_code ignored;
    return name == name_ || wholeName(name) == whole_ || fs::equivalent(name, name_, ignored);
  }

private:
  bool isOneOf(const std::optional<NumberedPath> &set) const {
    if (!set || !whole_.starts_with(set->before()) || !whole_.ends_with(set->after()))
      return false;
    const std::size_t others = set->before().size() + set->after().size();
    if (whole_.size() < others + set->digits())
      return false;
    const std::string_view digits =
        std::string_view(whole_).substr(set->before().size(), whole_.size() - others);
    return digits.find_first_not_of("0123456789") == std::string_view::npos;
  }

  std::string name_, whole_;
};

/// The file that --stats was given, if what else has its name is in danger: pipes and devices take both.
std::optional<FiguresFile> figuresFileOf(const std::string &stats) {
  const std::string file = stats == "-" ? "/dev/stdout" : stats;
  std::error_code ignored;
  return file.empty() || fs::is_other(file, ignored) ? std::nullopt : std::optional(FiguresFile(file));
}

} // namespace

Expected<void> checkFiguresFile(const CommandLine &command) {
  const std::optional<Option> stats = command.find("--stats");
  if (!stats || stats->count() == 0)
    return {};
  const std::optional<FiguresFile> figures = figuresFileOf(stats->written().back());
  if (!figures)
    return {};
  const auto isFigures = [&](const std::string &value) { return figures->isNamedBy(value); };
  for (const Option &option : command.options())
    if (option.takesValue() && option.choices().empty() && !option.isCalled("--stats") &&
        std::ranges::any_of(option.written(), isFigures))
      return Error::usage("--stats and " + option.name() + " both name '" + figures->name() +
                          "'; give the figures a file of their own");
  return {};
}

Expected<void> checkFiguresApart(const std::string &stats, const std::string &made) {
  const std::optional<FiguresFile> figures = figuresFileOf(stats);
  if (!figures || !figures->isOf(made))
    return {};
  return Error::usage("--stats names '" + stats +
                      "', which the command writes itself; give the figures a file of their own");
}

} // namespace voxc::tool
