// Kernels in other shading languages: what can be one, and what it begins with.
#include "voxc/Kernel/Translate.h"

#include "SpirvCross.h"

#include "voxc/Emit/Emit.h"

#include <cstdio>

namespace voxc {
namespace {

Expected<void> checkKernel(const Kernel &kernel, ShadingLanguage language) {
  const std::string name(toString(language));
  if (kernel.addressing != Addressing::Buffer)
    return Error::input(name + " cannot reach words by addressing=" +
                        std::string(toString(kernel.addressing)) + ": leave that out");
  if (kernel.arithmetic != Arithmetic::Any)
    return Error::input("a kernel of arithmetic=" + std::string(toString(kernel.arithmetic)) +
                        " asks for what " + name + " cannot say: compile it with arithmetic=any");
  return {};
}

/// What must be the same of a volume.
std::string digestComment(const Kernel &kernel) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(kernel.storageDigest));
  return std::string("// The digest of the format's storage is 0x") + digits +
         ", and that of a volume must be the same.\n";
}

} // namespace

bool canTranslate() { return kHasSpirvCross; }

Expected<std::string> translateKernel(const Kernel &kernel, ShadingLanguage language) {
  VOXC_TRY(checkKernel(kernel, language));
  auto text = VOXC_TRY(spirvCross(kernel.spirv, language));
  const std::string_view lacking = language == ShadingLanguage::Hlsl ? carryFunctions() : "";
  return digestComment(kernel) + std::string(lacking) + "\n" + text;
}

} // namespace voxc
