// Which files a pattern names.
#include "voxc/Input/NumberedPaths.h"

#include "voxc/Support/NumberedPath.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace voxc {

namespace {

/// The number of a file's name by a pattern: what stands between its two texts, with as many digits as the
/// pattern writes.
std::optional<std::uint64_t> numberOf(const NumberedPath &pattern, const std::string &path) {
  const std::string_view before = pattern.before(), after = pattern.after();
  if (path.size() <= before.size() + after.size() || !path.starts_with(before) || !path.ends_with(after))
    return std::nullopt;
  const char *const begin = path.data() + before.size();
  const char *const end = path.data() + path.size() - after.size();
  std::uint64_t number = 0;
  const auto parsed = std::from_chars(begin, end, number);
  const bool isNumber = parsed.ec == std::errc() && parsed.ptr == end;
  return isNumber && pattern(number) == path ? std::optional(number) : std::nullopt;
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
  const std::size_t slash = pattern.before().rfind('/');
  const std::string folder = slash == std::string::npos ? "" : pattern.before().substr(0, slash + 1);
  std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, ignored), end;
  for (; !ignored && entry != end; entry.increment(ignored))
    if (const auto number = numberOf(pattern, folder + entry->path().filename().string()))
      numbers.push_back(*number);
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

bool namesFiles(const std::string &path) {
  const auto pattern = NumberedPath::parse(path);
  return pattern && !numbersOf(*pattern).empty();
}

} // namespace voxc
