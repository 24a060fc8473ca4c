// Kernels in other shading languages: what can be one, and what it begins with.
#include "voxc/Kernel/Translate.h"

#include "SpirvCross.h"

#include "voxc/Emit/Emit.h"

namespace voxc {
namespace {

Expected<void> checkKernel(const Kernel &kernel, ShadingLanguage language) {
  const std::string name(toString(language));
  if (kernel.addressing != Addressing::Buffer)
    return Error::input(name + " cannot reach words by addressing=" +
                        std::string(toString(kernel.addressing)) + ": leave that out");
  if (kernel.arithmetic != Arithmetic::Any)
    return Error::input("a kernel of arithmetic=" + std::string(toString(kernel.arithmetic)) +
                        " has doubles, which " + name + " has not: compile it with arithmetic=any");
  return {};
}

} // namespace

bool canTranslate() { return kHasSpirvCross; }

Expected<std::string> translateKernel(const Kernel &kernel, ShadingLanguage language) {
  if (auto checked = checkKernel(kernel, language); !checked)
    return checked.error();
  auto text = spirvCross(kernel.spirv, language);
  if (text && language == ShadingLanguage::Hlsl)
    text = std::string(carryFunctions()) + "\n" + *text;
  return text;
}

} // namespace voxc
