// The text of build plans.
#include "cluster/BuildPlan.h"

#include "cluster/TextDigest.h"

#include "voxc/Support/File.h"

#include <bit>
#include <charconv>
#include <optional>

namespace voxc::tool::cluster {
namespace {

constexpr std::string_view kTitle = "voxc build plan 2\n";
constexpr std::string_view kDigestKey = "digest ";
constexpr std::size_t kDigestDigits = 16;
constexpr std::uint64_t kMostParts = std::uint64_t{1} << 20;

std::string bodyOf(const BuildPlan &plan) {
  const std::string ir = printIr(plan.format);
  TextDigest options;
  for (const std::string &option : plan.options)
    options.add(option);
  TextDigest input;
  input.add(plan.input);
  for (const InputFile &file : plan.files)
    input.add(file.digest);
  std::string text;
  const auto line = [&](const std::string &key, const std::string &value) {
    text += key + " " + value + "\n";
  };
  line("format-digest", TextDigest().add(ir).hex());
  line("input-digest", input.hex());
  line("options-digest", options.hex());
  line("input", plan.input);
  for (const InputFile &file : plan.files)
    line("file " + file.digest, file.path);
  for (const std::string &option : plan.options)
    line("option", option);
  line("volume", plan.volume);
  line("compress", plan.compress ? "yes" : "no");
  line("fan-in", std::to_string(plan.fanIn));
  line("extent", std::to_string(plan.extent.x) + " " + std::to_string(plan.extent.y) + " " +
                     std::to_string(plan.extent.z));
  line("cubes", std::to_string(plan.cubes.count) + " of side " + std::to_string(1 << plan.cubes.log2Side));
  for (std::size_t i = 0; i < plan.ranges.size(); ++i)
    line("part " + std::to_string(i), std::to_string(plan.ranges[i].begin) + " to " +
                                          std::to_string(plan.ranges[i].end) + " cost " +
                                          std::to_string(plan.ranges[i].cost));
  return text + ir;
}

/// Takes the lines of a plan one after the other; the first that is not as it should be is remembered.
class PlanReader {
public:
  explicit PlanReader(std::string_view text) : text_(text) {}

  std::string_view rest() const { return text_; }
  bool isAt(std::string_view key) const { return text_.starts_with(key); }
  bool failed() const { return failed_; }
  void fail() { failed_ = true; }

  /// What stands behind `key` on the next line.
  std::string_view value(std::string_view key) {
    const std::size_t end = text_.find('\n');
    if (!isAt(key) || text_.size() <= key.size() || text_[key.size()] != ' ' ||
        end == std::string_view::npos || end <= key.size()) {
      fail();
      return {};
    }
    const std::string_view value = text_.substr(key.size() + 1, end - key.size() - 1);
    text_.remove_prefix(end + 1);
    return value;
  }

  /// Numbers with these words between them, on the next line behind `key`.
  std::vector<std::uint64_t> numbers(std::string_view key, const std::vector<std::string_view> &between) {
    std::string_view words = value(key);
    std::vector<std::uint64_t> numbers;
    for (std::size_t i = 0; i <= between.size() && !failed_; ++i) {
      std::uint64_t number = 0;
      const auto [end, wrong] = std::from_chars(words.data(), words.data() + words.size(), number);
      words.remove_prefix(static_cast<std::size_t>(end - words.data()));
      const std::string_view behind = i < between.size() ? between[i] : "";
      if (wrong != std::errc() || !words.starts_with(behind) || (behind.empty() && !words.empty()))
        fail();
      else
        words.remove_prefix(behind.size());
      numbers.push_back(number);
    }
    numbers.resize(between.size() + 1);
    return numbers;
  }

private:
  std::string_view text_;
  bool failed_ = false;
};

void readRanges(PlanReader &reader, BuildPlan &plan) {
  while (!reader.failed() && reader.isAt("part ") && plan.ranges.size() < kMostParts) {
    const auto range = reader.numbers("part " + std::to_string(plan.ranges.size()), {" to ", " cost "});
    plan.ranges.push_back({range[0], range[1], range[2]});
  }
  std::uint64_t at = 0;
  for (const CubeRange &range : plan.ranges) {
    if (range.begin != at || range.end < at)
      reader.fail();
    at = range.end;
  }
  if (plan.ranges.empty() || at != plan.cubes.count)
    reader.fail();
}

/// The extent and its cubes must be such as a volume can have.
void readCubes(PlanReader &reader, BuildPlan &plan) {
  const auto extent = reader.numbers("extent", {" ", " "});
  const auto cubes = reader.numbers("cubes", {" of side "});
  constexpr std::uint64_t kMost = std::uint64_t{1} << kMaxLog2Extent;
  const std::uint64_t side = cubes[1];
  if (extent[0] > kMost || extent[1] > kMost || extent[2] > kMost || side == 0 || side > kMost ||
      (side & (side - 1)) != 0 || cubes[0] == 0 || cubes[0] > std::uint64_t{1} << 3 * kMaxLog2Extent)
    return reader.fail();
  plan.extent = {static_cast<int>(extent[0]), static_cast<int>(extent[1]), static_cast<int>(extent[2])};
  plan.cubes = {std::countr_zero(side), cubes[0]};
}

std::optional<BuildPlan> parseBody(std::string_view body) {
  PlanReader reader(body);
  BuildPlan plan;
  reader.value("format-digest");
  reader.value("input-digest");
  reader.value("options-digest");
  plan.input = reader.value("input");
  while (!reader.failed() && reader.isAt("file ")) {
    const std::string_view file = reader.value("file");
    if (file.size() <= kDigestDigits + 1)
      return std::nullopt;
    plan.files.push_back(
        {std::string(file.substr(0, kDigestDigits)), std::string(file.substr(kDigestDigits + 1))});
  }
  while (!reader.failed() && reader.isAt("option "))
    plan.options.emplace_back(reader.value("option"));
  plan.volume = reader.value("volume");
  plan.compress = reader.value("compress") == "yes";
  plan.fanIn = reader.numbers("fan-in", {})[0];
  if (plan.fanIn < kLeastFanIn || plan.fanIn > kMostFanIn)
    reader.fail();
  readCubes(reader, plan);
  if (!reader.failed())
    readRanges(reader, plan);
  if (reader.failed())
    return std::nullopt;
  Diagnostics diagnostics;
  plan.format = parseIr(reader.rest(), diagnostics);
  // What was read must be all that there is: its text says the same.
  return diagnostics.hasErrors() || bodyOf(plan) != body ? std::nullopt : std::optional(std::move(plan));
}

} // namespace

Expected<std::string> fileDigest(const std::string &path) {
  TextDigest digest;
  VOXC_TRY(digest.addFile(path));
  return digest.hex();
}

Expected<void> checkInput(const BuildPlan &plan) {
  for (const InputFile &file : plan.files) {
    const auto digest = VOXC_TRY(fileDigest(file.path));
    if (digest != file.digest)
      return Error::input("'" + file.path +
                          "' is not what it was when the plan was made; make the plan again");
  }
  return {};
}

FragmentShare BuildPlan::shareOf(const WorkItem &item) const {
  const MergeTree merges = tree();
  const auto [first, last] = merges.partsOf(item);
  return {item.index, merges.count(item.level), ranges[first].begin, ranges[last - 1].end};
}

std::string BuildPlan::digest() const { return TextDigest().add(bodyOf(*this)).hex(); }

std::string printPlan(const BuildPlan &plan) {
  const std::string body = bodyOf(plan);
  return std::string(kTitle) + std::string(kDigestKey) + TextDigest().add(body).hex() + "\n" + body;
}

Expected<BuildPlan> parsePlan(std::string_view text, const std::string &name) {
  const std::size_t head = kTitle.size() + kDigestKey.size() + kDigestDigits + 1;
  if (!text.starts_with("voxc build plan "))
    return Error::input("'" + name + "' is no build plan; voxc plan writes one");
  if (!text.starts_with(kTitle))
    return Error::input("'" + name + "' is a build plan of another version; make it again with this voxc");
  if (text.size() <= head || text[head - 1] != '\n' || !text.substr(kTitle.size()).starts_with(kDigestKey) ||
      TextDigest().add(text.substr(head)).hex() !=
          text.substr(kTitle.size() + kDigestKey.size(), kDigestDigits))
    return Error::input("'" + name +
                        "' is damaged or was changed: its digest does not match its text; make it again");
  auto plan = parseBody(text.substr(head));
  if (!plan)
    return Error::input("'" + name + "' contradicts itself; make it again");
  return std::move(*plan);
}

Expected<BuildPlan> loadPlan(const std::string &path) {
  const auto text = readTextFile(path);
  return text ? parsePlan(*text, path) : text.error();
}

} // namespace voxc::tool::cluster
