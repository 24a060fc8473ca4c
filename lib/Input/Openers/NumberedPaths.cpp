// Which files a pattern names.
#include "voxc/Input/NumberedPaths.h"

#include "Support/Text.h"
#include "voxc/Support/NumberedPath.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace voxc {

namespace {

/// The number that stands between the two texts of a pattern, in any digits and letters.
std::optional<std::uint64_t> looseNumberOf(const NumberedPath &pattern, const std::string &path) {
  const std::size_t before = pattern.before().size(), after = pattern.after().size();
  if (path.size() <= before + after)
    return std::nullopt;
  const auto isSame = [](std::string_view a, std::string_view b) { return lowerCase(a) == lowerCase(b); };
  const std::string_view name = path;
  if (!isSame(name.substr(0, before), pattern.before()) ||
      !isSame(name.substr(name.size() - after), pattern.after()))
    return std::nullopt;
  const char *const end = path.data() + path.size() - after;
  std::uint64_t number = 0;
  const auto parsed = std::from_chars(path.data() + before, end, number);
  return parsed.ec == std::errc() && parsed.ptr == end ? std::optional(number) : std::nullopt;
}

/// The number of a file's name by a pattern: with as many digits as it writes.
std::optional<std::uint64_t> numberOf(const NumberedPath &pattern, const std::string &path) {
  const auto number = looseNumberOf(pattern, path);
  return number && pattern(*number) == path ? number : std::nullopt;
}

/// Calls `look(path)` for all files of the folder in which those of a pattern lie.
template <typename Look> void forFiles(const NumberedPath &pattern, const Look &look) {
  const std::size_t slash = pattern.before().rfind('/');
  const std::string folder = slash == std::string::npos ? "" : pattern.before().substr(0, slash + 1);
  std::error_code ignored;
  std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, ignored), end;
  for (; !ignored && entry != end; entry.increment(ignored))
    look(folder + entry->path().filename().string());
}

/// The numbers of all files that are there, in order.
std::vector<std::uint64_t> numbersOf(const NumberedPath &pattern) {
  std::vector<std::uint64_t> numbers;
  std::error_code ignored;
  if (pattern.after().find('/') != std::string::npos) {
    // The number is that of a folder: they are tried one by one.
    for (std::uint64_t number = std::filesystem::exists(pattern(0), ignored) ? 0 : 1;
         std::filesystem::exists(pattern(number), ignored); ++number)
      numbers.push_back(number);
    return numbers;
  }
  forFiles(pattern, [&](const std::string &path) {
    if (const auto number = numberOf(pattern, path))
      numbers.push_back(*number);
  });
  std::ranges::sort(numbers);
  return numbers;
}

} // namespace

Expected<std::vector<std::string>> numberedPaths(const std::string &path, std::size_t most) {
  const auto pattern = NumberedPath::parse(path);
  if (!pattern)
    return std::vector<std::string>{path};
  const std::vector<std::uint64_t> numbers = numbersOf(*pattern);
  if (numbers.empty())
    return Error::input("'" + path + "' names no file: there is neither " + (*pattern)(0) + " nor " +
                        (*pattern)(1) + ", nor one of a higher number");
  if (numbers.size() > most)
    return Error::input("'" + path + "' names more than " + std::to_string(most) +
                        " files, which is all that may be");
  // A set that is being written, or was left, lacks its first two files: they get their names last.
  if (numbers.front() == 2)
    return Error::input("'" + path + "' names no whole set: " + (*pattern)(2) + " is there, but neither " +
                        (*pattern)(0) + " nor " + (*pattern)(1));
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && numbers[i] != numbers[i - 1] + 1)
      return Error::input("'" + path + "' names no whole set: there is no " + (*pattern)(numbers[i - 1] + 1) +
                          ", but " + (*pattern)(numbers[i]) + " is there");
    paths.push_back((*pattern)(numbers[i]));
  }
  return paths;
}

std::vector<std::string> saysBesides(const std::string &path) {
  const auto pattern = NumberedPath::parse(path);
  if (!pattern || pattern->after().find('/') != std::string::npos)
    return {};
  std::uint64_t count = 0;
  std::string first;
  forFiles(*pattern, [&](const std::string &file) {
    if (!looseNumberOf(*pattern, file) || numberOf(*pattern, file))
      return;
    ++count;
    first = first.empty() ? file : std::min(first, file);
  });
  if (count == 0)
    return {};
  return {countedAre(count, "file") + " left out that " + (count == 1 ? "differs" : "differ") + " from '" +
          path + "' in digits or letters alone: '" + first + "'" + (count > 1 ? " and others" : "")};
}

bool namesFiles(const std::string &path) {
  const auto pattern = NumberedPath::parse(path);
  return pattern && !numbersOf(*pattern).empty();
}

} // namespace voxc
