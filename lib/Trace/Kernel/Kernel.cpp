// Kernels: the facts that voxc leaves in a module, written and read.
#include "voxc/Trace/Kernel.h"

#include "Spirv.h"

#include "voxc/Support/File.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <optional>

namespace voxc {
namespace {

static_assert(std::endian::native == std::endian::little, "modules and volumes are mapped as they are");

constexpr std::string_view kFactsPrefix = "voxc kernel ";
constexpr std::string_view kFactsVersion = "3";
constexpr std::string_view kBounds = "bounds=yes";

std::optional<std::uint64_t> parseDigest(std::string_view text) {
  std::uint64_t digest = 0;
  auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), digest, 16);
  if (text.size() != 16 || problem != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return digest;
}

/// Takes the text up to the next blank off the front of `text`.
std::string_view takeWord(std::string_view &text) {
  std::size_t blank = text.find(' ');
  std::string_view word = text.substr(0, blank);
  text = blank == std::string_view::npos ? std::string_view{} : text.substr(blank + 1);
  return word;
}

/// Takes the next word off `text` and returns what follows `key` in it; nothing if it does not start so.
std::optional<std::string_view> takeValue(std::string_view &text, std::string_view key) {
  std::string_view word = takeWord(text);
  if (!word.starts_with(key))
    return std::nullopt;
  return word.substr(key.size());
}

Expected<void> parseFacts(std::string_view facts, Kernel &kernel) {
  std::string_view rest = facts.substr(kFactsPrefix.size());
  std::string_view version = takeWord(rest);
  if (version != kFactsVersion)
    return Error::input("this kernel has version " + std::string(version.substr(0, 16)) +
                        ", but this voxc reads version " + std::string(kFactsVersion) + ": compile it again");
  std::optional<std::uint64_t> digest;
  std::optional<Addressing> addressing;
  std::optional<Loops> loops;
  std::optional<Arithmetic> arithmetic;
  if (auto value = takeValue(rest, "storage="))
    digest = parseDigest(*value);
  if (auto value = takeValue(rest, "addressing="))
    addressing = fromString<Addressing>(*value);
  if (auto value = takeValue(rest, "loops="))
    loops = fromString<Loops>(*value);
  if (auto value = takeValue(rest, "arithmetic="))
    arithmetic = fromString<Arithmetic>(*value);
  kernel.bounded = rest == kBounds;
  if (!digest || !addressing || !loops || !arithmetic || !(rest.empty() || kernel.bounded))
    return Error::input(
        "this kernel's own description is broken: it should end in \"storage=<16 hex digits> "
        "addressing=<buffer|segments|paged> loops=<whole|cut> arithmetic=<any|nearest|ieee>\", and may have "
        "\"bounds=yes\" behind that");
  kernel.storageDigest = *digest;
  kernel.addressing = *addressing;
  kernel.loops = *loops;
  kernel.arithmetic = *arithmetic;
  return {};
}

} // namespace

std::string kernelFacts(const Kernel &kernel) {
  std::array<char, 17> digits;
  std::snprintf(digits.data(), digits.size(), "%016llx",
                static_cast<unsigned long long>(kernel.storageDigest));
  std::string facts(kFactsPrefix);
  facts.append(kFactsVersion).append(" storage=").append(digits.data());
  facts.append(" addressing=").append(toString(kernel.addressing));
  facts.append(" loops=").append(toString(kernel.loops));
  facts.append(" arithmetic=").append(toString(kernel.arithmetic));
  return kernel.bounded ? facts.append(" ").append(kBounds) : facts;
}

Expected<Kernel> Kernel::fromSpirv(std::vector<std::uint32_t> spirv) {
  std::optional<std::string> facts;
  auto findFacts = [&](const spirv::Instruction &instruction) {
    if (facts || instruction.opcode != spirv::kOpModuleProcessed)
      return;
    auto text = spirv::literalString(instruction.operands);
    if (text && text->starts_with(kFactsPrefix))
      facts = std::move(text);
  };
  VOXC_TRY(spirv::forEachInstruction(spirv, findFacts));
  if (!facts)
    return Error::input("this SPIR-V module was not made by voxc: it does not say which volumes it fits");
  Kernel kernel;
  VOXC_TRY(parseFacts(*facts, kernel));
  kernel.spirv = std::move(spirv);
  return kernel;
}

Expected<Kernel> Kernel::load(const std::string &path) {
  auto file = VOXC_TRY(MappedFile::open(path));
  std::span<const std::byte> bytes = file.bytes();
  if (bytes.size() % sizeof(std::uint32_t) != 0)
    return Error::input(path + " is not SPIR-V: its " + std::to_string(bytes.size()) +
                        " bytes are no multiple of 4");
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  if (!words.empty())
    std::memcpy(words.data(), bytes.data(), bytes.size());
  auto kernel = fromSpirv(std::move(words));
  if (!kernel)
    return Error::input(path + ": " + kernel.error().message);
  return kernel;
}

} // namespace voxc
