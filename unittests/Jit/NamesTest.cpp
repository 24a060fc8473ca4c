// Functions of compiled code have names for debuggers.
#include "Jit/Jit.h"

#include <gtest/gtest.h>

#include <string_view>

// The interface of GDB for code that is made in a process: its documentation names and numbers these.
extern "C" {
struct JitCodeEntry {
  JitCodeEntry *next;
  JitCodeEntry *previous;
  const char *file;
  std::uint64_t fileBytes;
};
struct JitDescriptor {
  std::uint32_t version;
  std::uint32_t action;
  JitCodeEntry *relevant;
  JitCodeEntry *first;
};
extern JitDescriptor __jit_debug_descriptor; // NOLINT(bugprone-reserved-identifier)
}

namespace voxc {
namespace {

constexpr const char *kText = "extern \"C\" int named_for_debuggers(int x) { return x + 1; }";

/// How many files a debugger is told of that know of a name.
int filesThatKnow(std::string_view name) {
  int count = 0;
  for (const JitCodeEntry *entry = __jit_debug_descriptor.first; entry; entry = entry->next)
    count += std::string_view(entry->file, entry->fileBytes).find(name) != std::string_view::npos;
  return count;
}

TEST(JitNames, AreToldToDebuggersAsLongAsTheCodeIsThere) {
  EXPECT_EQ(filesThatKnow("named_for_debuggers"), 0);
  {
    const auto code = JitCode::compile({{"named.cpp", kText}}, {});
    ASSERT_TRUE(code) << code.error().message;
    const auto other = JitCode::compile({{"named.cpp", kText}}, {});
    ASSERT_TRUE(other) << other.error().message;
    for (const auto *const each : {&code, &other}) {
      const auto function = (*each)->find("named_for_debuggers");
      ASSERT_TRUE(function) << function.error().message;
      EXPECT_EQ(reinterpret_cast<int (*)(int)>(*function)(2), 3);
    }
    EXPECT_EQ(filesThatKnow("named_for_debuggers"), 2);
  }
  EXPECT_EQ(filesThatKnow("named_for_debuggers"), 0);
}

} // namespace
} // namespace voxc
