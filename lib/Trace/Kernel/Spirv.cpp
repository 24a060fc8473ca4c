// SPIR-V modules as sequences of instructions.
#include "Spirv.h"

namespace voxc::spirv {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::uint32_t kSwappedMagic = 0x03022307;

Expected<void> checkHeader(std::span<const std::uint32_t> module) {
  if (module.empty() || (module[0] != kMagic && module[0] != kSwappedMagic))
    return Error::input("this is not SPIR-V: it does not begin with the number 0x07230203");
  if (module[0] == kSwappedMagic)
    return Error::input("this SPIR-V module is big-endian; voxc reads little-endian ones");
  if (module.size() < kHeaderWords)
    return Error::input("this SPIR-V module is truncated: its header has 5 words, but only " +
                        std::to_string(module.size()) + " are there");
  return {};
}

Error badInstruction(std::size_t position, const std::string &problem) {
  return Error::input("this SPIR-V module is broken: the instruction at word " + std::to_string(position) +
                      " " + problem);
}

} // namespace

Expected<void> forEachInstruction(std::span<const std::uint32_t> module,
                                  const std::function<void(const Instruction &)> &visit) {
  VOXC_TRY(checkHeader(module));
  for (std::size_t position = kHeaderWords; position < module.size();) {
    std::uint32_t words = module[position] >> 16;
    std::size_t left = module.size() - position;
    if (words == 0)
      return badInstruction(position, "has no words");
    if (words > left)
      return badInstruction(position, "has " + std::to_string(words) + " words, but only " +
                                          std::to_string(left) + " are left");
    visit({module[position] & 0xffff, module.subspan(position + 1, words - 1)});
    position += words;
  }
  return {};
}

std::optional<std::string> literalString(std::span<const std::uint32_t> operands) {
  std::string text;
  for (std::uint32_t word : operands) {
    for (int shift = 0; shift < 32; shift += 8) {
      char character = static_cast<char>(word >> shift & 0xff);
      if (character == '\0')
        return text;
      text += character;
    }
  }
  return std::nullopt;
}

} // namespace voxc::spirv
