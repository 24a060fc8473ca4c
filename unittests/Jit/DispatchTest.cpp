// Which variant of a kernel a processor gets, for processors that are not here. Objects for x86-64 alone have
// variants.
#ifdef __x86_64__
#include "Jit/Jit.h"

#include "voxc/Emit/Emit.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace voxc {
namespace {

/// Variants that tell of themselves, and a way to the choice.
constexpr const char *kVariants = R"(
namespace voxc {
void trace_16_rays(const uint *, const float *, uint *hits, unsigned long long, int, float) { hits[0] = 4; }
void trace_8_rays(const uint *, const float *, uint *hits, unsigned long long, int, float) { hits[0] = 3; }
void trace_single_rays(const uint *, const float *, uint *hits, unsigned long long, int, float) { hits[0] = 1; }
}
extern "C" unsigned choose(const unsigned *f) {
  unsigned level;
  voxc::best_kernel({f[0], f[1], f[2], f[3]})(nullptr, nullptr, &level, 0, 0, 0);
  return level;
}
)";

/// What a processor tells: ecx of cpuid 1, ebx of cpuid 7, ecx of cpuid 0x80000001, xgetbv.
using Words = std::array<std::uint32_t, 4>;

/// The lists of the System V ABI.
constexpr Words kNeededByLevel3 = {0x38d83201, 0x00000128, 0x00000021, 0x06};
constexpr Words kNeededByLevel4 = {0x38d83201, 0xd0030128, 0x00000021, 0xe6};

class Dispatch : public testing::Test {
protected:
  Dispatch() : code_(compiled()) {}

  template <typename Function> Function *find(const char *name) const {
    return reinterpret_cast<Function *>(*code_.find(name));
  }
  unsigned choose(const Words &words) const {
    return find<unsigned(const std::uint32_t *)>("choose")(words.data());
  }

private:
  static JitCode compiled() {
    const std::string text = emitDispatchCpp("trace") + kVariants;
    auto code = JitCode::compile({{"dispatch.cpp", text}}, {.optimisation = 2, .processor = ""});
    EXPECT_TRUE(code) << code.error().message;
    return std::move(*code);
  }

  JitCode code_;
};

TEST_F(Dispatch, GivesTheHighestLevelThatAProcessorHasAllOf) {
  EXPECT_EQ(choose({}), 1u);
  EXPECT_EQ(choose(kNeededByLevel3), 3u);
  EXPECT_EQ(choose(kNeededByLevel4), 4u);
  EXPECT_EQ(choose({~0u, ~0u, ~0u, ~0u}), 4u);
  for (std::size_t word = 0; word < 4; ++word)
    for (unsigned bit = 0; bit < 32; ++bit) {
      Words without = {~0u, ~0u, ~0u, ~0u};
      without[word] &= ~(1u << bit);
      const bool lacks3 = kNeededByLevel3[word] >> bit & 1, lacks4 = kNeededByLevel4[word] >> bit & 1;
      EXPECT_EQ(choose(without), lacks3   ? 1u
                                 : lacks4 ? 3u
                                          : 4u)
          << "without bit " << bit << " of word " << word;
    }
}

TEST_F(Dispatch, AsksTheProcessorItRunsOn) {
  const auto trace =
      find<void(const void *, const void *, unsigned *, unsigned long long, int, float)>("trace");
  for (int call = 0; call < 2; ++call) {
    unsigned level = 0;
    trace(nullptr, nullptr, &level, 0, 0, 0);
    EXPECT_EQ(level, __builtin_cpu_supports("x86-64-v4")   ? 4u
                     : __builtin_cpu_supports("x86-64-v3") ? 3u
                                                           : 1u);
  }
}

} // namespace
} // namespace voxc
#endif
