// Fuzzes kernels in SPIR-V: what says which volumes it fits must say the same when it is written again.
#include "Expect.h"
#include "WordMutator.h"

#include "voxc/Trace/Kernel.h"

#include <cstring>
#include <utility>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  std::vector<std::uint32_t> words(size / sizeof(std::uint32_t));
  if (!words.empty())
    std::memcpy(words.data(), data, words.size() * sizeof(std::uint32_t));
  const auto kernel = voxc::Kernel::fromSpirv(words);
  if (!kernel)
    return 0;
  const std::string facts = voxc::kernelFacts(*kernel);
  voxc::fuzz::expect(kernel->spirv == words && facts.starts_with("voxc kernel "));
  // The module in a file of the same words must be the same kernel.
  const auto again = voxc::Kernel::fromSpirv(std::move(words));
  voxc::fuzz::expect(again && voxc::kernelFacts(*again) == facts);
  return 0;
}
