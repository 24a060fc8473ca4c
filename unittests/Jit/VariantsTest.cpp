// Variants for several processors in one object keep to themselves, whatever the linker knows of equal
// functions. Objects for x86-64 alone have variants.
#ifdef __x86_64__
#include "Jit/Variants.h"
#include "Jit/Jit.h"

#include <gmock/gmock.h>

namespace voxc {
namespace {

using testing::HasSubstr;

constexpr const char *kTwoProcessors[] = {"x86-64-v3", "x86-64"};

/// Functions and a variable of the kinds of which a linker keeps one for a program.
constexpr const char *kShared = R"(
#ifdef __AVX2__
constexpr int kLevel = 3;
#else
constexpr int kLevel = 1;
#endif
inline int calls = 0;
template <typename T> [[gnu::noinline]] T level(T factor) { asm volatile(""); return factor * kLevel; }
template int level(int);
[[gnu::noinline]] inline int count() { asm volatile(""); return ++calls; }
extern "C" int answer() { return 10 * level(1) + count(); }
)";

Expected<std::string> compiled(const char *text, const char *dispatcher) {
  return compileVariants({{"text.cpp", text}}, {.optimisation = 2}, kTwoProcessors,
                         {"dispatch.cpp", dispatcher});
}

TEST(Variants, HaveFunctionsAndVariablesOfTheirOwn) {
  const auto object = compiled(kShared, R"(
extern "C" int third() asm("answer.x86_64_v3");
extern "C" int first() asm("answer.x86_64");
extern "C" int answer() {
  const int once = third(), again = third();
  return 10000 * once + 100 * again + first();
}
)");
  ASSERT_TRUE(object) << object.error().message;
  const auto code = JitCode::link(*object);
  ASSERT_TRUE(code) << code.error().message;
  const auto answer = code->find("answer");
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(reinterpret_cast<int (*)()>(*answer)(), 313211);
}

TEST(Variants, AreNotSeenFromOutside) {
  const auto object = compiled(kShared, "extern \"C\" int other() { return 1; }");
  ASSERT_TRUE(object) << object.error().message;
  const auto code = JitCode::link(*object);
  ASSERT_TRUE(code) << code.error().message;
  EXPECT_TRUE(code->find("other"));
  for (const char *name : {"answer", "answer.x86_64", "answer.x86_64_v3", "calls", "calls.x86_64"})
    EXPECT_FALSE(code->find(name)) << name;
}

TEST(Variants, TellWhatIsWrongInAnyOfThem) {
  const auto variant = compiled("#ifdef __AVX2__\n#error no\n#endif\n", "");
  ASSERT_FALSE(variant);
  EXPECT_THAT(variant.error().message, HasSubstr("text.cpp:2:2: error: no"));
  const auto dispatcher = compiled("", "what is this");
  ASSERT_FALSE(dispatcher);
  EXPECT_THAT(dispatcher.error().message, HasSubstr("dispatch.cpp:1:1: error:"));
}

} // namespace
} // namespace voxc
#endif
