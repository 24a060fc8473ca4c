// Writing voxc's facts into a SPIR-V module.
#include "Stages.h"

#include <algorithm>
#include <cstring>

namespace voxc {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kOpModuleProcessed = 330;
// OpUndef, OpString and OpTypes lie below 72; of a module's sections up to the debug names, these are the
// opcodes: what is not among them begins the annotations, before which OpModuleProcessed must stand.
constexpr std::uint32_t kBeforeAnnotations[] = {2, 3, 4, 5, 6, 7, 10, 11, 14, 15, 16, 17, 330, 331};

std::size_t annotationsBegin(const SpirvWords &module) {
  std::size_t at = kHeaderWords;
  while (at < module.size() && std::ranges::count(kBeforeAnnotations, module[at] & 0xffff) > 0)
    at += std::max<std::size_t>(module[at] >> 16, 1);
  return std::min(at, module.size());
}

} // namespace

SpirvWords addModuleProcessed(const SpirvWords &module, std::string_view facts) {
  // A literal string ends with a zero byte and is padded to a whole word.
  SpirvWords instruction(1 + facts.size() / 4 + 1);
  instruction[0] = static_cast<std::uint32_t>(instruction.size() << 16) | kOpModuleProcessed;
  std::memcpy(instruction.data() + 1, facts.data(), facts.size());
  SpirvWords result = module;
  result.insert(result.begin() + static_cast<std::ptrdiff_t>(annotationsBegin(module)), instruction.begin(),
                instruction.end());
  return result;
}

} // namespace voxc
