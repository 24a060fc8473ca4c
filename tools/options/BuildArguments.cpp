// Options of building, and sizes as people write them.
#include "options/BuildArguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <thread>

namespace voxc::tool {

namespace {

struct Unit {
  std::string_view name;
  std::uint64_t bytes;
};

constexpr std::array<Unit, 8> kUnits{{{"", 1},
                                      {"K", 1ULL << 10},
                                      {"KiB", 1ULL << 10},
                                      {"M", 1ULL << 20},
                                      {"MiB", 1ULL << 20},
                                      {"G", 1ULL << 30},
                                      {"GiB", 1ULL << 30},
                                      {"TiB", 1ULL << 40}}};

/// A whole number and a unit, or nothing.
std::optional<std::uint64_t> parseSize(std::string_view text) {
  std::uint64_t number = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view name(end, static_cast<std::size_t>(text.data() + text.size() - end));
  const auto *unit = std::ranges::find(kUnits, name, &Unit::name);
  if (failure != std::errc() || unit == kUnits.end() || number > ~std::uint64_t{0} / unit->bytes)
    return std::nullopt;
  return number * unit->bytes;
}

std::string checkMemory(const std::string &text) {
  constexpr std::uint64_t kSmallest = std::uint64_t{16} << 20;
  const auto size = parseSize(text);
  return size && *size < kSmallest ? "'" + text + "' is too little memory; give 16MiB or more"
                                   : sizeProblem(text);
}

} // namespace

std::string sizeProblem(const std::string &text) {
  return parseSize(text)
             ? std::string()
             : "'" + text + "' is no size; write a number of bytes, or one with K, M, G or KiB, MiB, GiB";
}

void addMemoryArguments(const CommandLine &command, BuildArguments &arguments) {
  const OptionGroup group(command, "Memory and threads");
  command
      .add("--memory", arguments.memory,
           "Bound on the memory of building, such as 512MiB; default: a quarter of the machine's")
      .takes("SIZE")
      .check(checkMemory);
  command.add("--scratch", arguments.scratch, "Folder for what does not fit; default: $TMPDIR or /var/tmp")
      .takes("DIR");
}

void addCompressArgument(const CommandLine &command, bool &compress) {
  command.addFlag("--compress", compress,
                  "Store the volume in compressed pages: half the bytes, decoded when it is loaded");
}

void addThreadsArgument(const CommandLine &command, BuildArguments &arguments) {
  const OptionGroup group(command, "Memory and threads");
  command.add("--threads", arguments.threads, "Threads that build; default: as many as the machine has")
      .takes("N")
      .between(1u, 1024u);
}

void addMaxBytesArgument(const CommandLine &command, BuildArguments &arguments) {
  command
      .add("--max-bytes", arguments.maxBytes,
           "Fail as soon as the volume's words take more; default: what references can reach, 16GiB without "
           "granules")
      .takes("SIZE")
      .check(sizeProblem);
}

std::uint64_t bytesOf(const std::string &size) { return *parseSize(size); }

std::uint64_t maxWordsOf(const BuildArguments &arguments) {
  return arguments.maxBytes.empty() ? BuildOptions{}.maxWords
                                    : bytesOf(arguments.maxBytes) / sizeof(std::uint32_t);
}

std::shared_ptr<WorkingMemory> makeWorkingMemory(const BuildArguments &arguments) {
  if (arguments.memory.empty() && arguments.scratch.empty())
    return WorkingMemory::createDefault();
  const std::uint64_t bound =
      arguments.memory.empty() ? WorkingMemory::createDefault()->bound() : bytesOf(arguments.memory);
  return WorkingMemory::create(bound, arguments.scratch);
}

unsigned threadsOf(const BuildArguments &arguments) {
  return arguments.threads > 0 ? arguments.threads : std::max(std::thread::hardware_concurrency(), 1u);
}

} // namespace voxc::tool
