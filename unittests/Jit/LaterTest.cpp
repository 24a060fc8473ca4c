// Parts of compiled code that wait until they are called.
#include "Jit/Jit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include <pthread.h>

namespace voxc {
namespace {

constexpr const char *kFirst = R"(
extern "C" int twice(int x);
extern "C" int thrice(int x);
extern "C" int other(int x);
extern "C" int answer(int x) { return x < 0 ? other(x) : x & 1 ? twice(x) : thrice(x); }
)";
constexpr const char *kLater = R"(
extern "C" int twice(int x) { return 2 * x; }
extern "C" int thrice(int x) { return 3 * x; }
)";
constexpr const char *kNever = "extern \"C\" int other(int) { return 0; }";

struct Counts {
  std::atomic<int> later = 0;
  std::atomic<int> never = 0;
};

LaterPart part(std::vector<std::string> functions, const char *text, std::atomic<int> &count) {
  return {std::move(functions), [text, &count] {
            ++count;
            return compileToObject({{"part.cpp", text}}, {});
          }};
}

Expected<JitCode> linked(Counts &counts) {
  const auto first = compileToObject({{"first.cpp", kFirst}}, {});
  if (!first)
    return first.error();
  return JitCode::link(
      *first, {}, {part({"twice", "thrice"}, kLater, counts.later), part({"other"}, kNever, counts.never)});
}

using Function = int (*)(int x);

TEST(LaterParts, AreCompiledOnceByTheFirstCall) {
  Counts counts;
  const auto code = linked(counts);
  ASSERT_TRUE(code) << code.error().message;
  const auto answer = code->find("answer");
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(counts.later, 0);
  EXPECT_EQ(reinterpret_cast<Function>(*answer)(5), 10);
  EXPECT_EQ(reinterpret_cast<Function>(*answer)(4), 12);
  EXPECT_EQ(reinterpret_cast<Function>(*answer)(7), 14);
  EXPECT_EQ(counts.later, 1);
  EXPECT_EQ(counts.never, 0);
}

TEST(LaterParts, MayBeCalledFirstByManyThreads) {
  Counts counts;
  const auto code = linked(counts);
  ASSERT_TRUE(code) << code.error().message;
  const auto answer = reinterpret_cast<Function>(*code->find("answer"));
  std::atomic<int> wrong = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i)
      threads.emplace_back([&, i] { wrong += answer(i) != (i & 1 ? 2 : 3) * i; });
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(counts.later, 1);
}

/// As that of a job of a game.
constexpr std::size_t kSmallStack = 128 << 10;
/// A compiler goes into each parenthesis.
constexpr std::size_t kDeep = 200;

TEST(LaterParts, MayBeCalledFirstWhereTheStackIsSmall) {
  const std::string deep = "extern \"C\" int twice(int x) { return 2 * " + std::string(kDeep, '(') + "x" +
                           std::string(kDeep, ')') +
                           "; }\nextern \"C\" int thrice(int x) { return 3 * x; }\n";
  Counts counts;
  const auto first = compileToObject({{"first.cpp", kFirst}}, {});
  ASSERT_TRUE(first) << first.error().message;
  const auto code = JitCode::link(
      *first, {},
      {part({"twice", "thrice"}, deep.c_str(), counts.later), part({"other"}, kNever, counts.never)});
  ASSERT_TRUE(code) << code.error().message;
  void *answer = *code->find("answer");
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, kSmallStack), 0);
  pthread_t thread;
  const auto ask = [](void *function) -> void * {
    return reinterpret_cast<void *>(static_cast<std::intptr_t>(reinterpret_cast<Function>(function)(5)));
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, ask, answer), 0);
  void *result = nullptr;
  ASSERT_EQ(pthread_join(thread, &result), 0);
  pthread_attr_destroy(&attributes);
  EXPECT_EQ(reinterpret_cast<std::intptr_t>(result), 10);
  EXPECT_EQ(counts.later, 1);
}

TEST(LaterPartsDeathTest, EndTheProcessIfTheyCannotBeCompiled) {
  Counts counts;
  const auto first = compileToObject({{"first.cpp", kFirst}}, {});
  ASSERT_TRUE(first) << first.error().message;
  const auto code = JitCode::link(
      *first, {},
      {part({"twice", "thrice"}, "#error no", counts.later), part({"other"}, kNever, counts.never)});
  ASSERT_TRUE(code) << code.error().message;
  const auto answer = reinterpret_cast<Function>(*code->find("answer"));
  EXPECT_EQ(answer(-1), 0);
  EXPECT_DEATH(answer(1), "error: no");
}

} // namespace
} // namespace voxc
