// GDB's interface for code that is made in a process: a list that starts at a known name, and a function that
// is called when it changes, where debuggers wait.
#include "DebuggerEntries.h"

#include <llvm/ExecutionEngine/Orc/TargetProcess/JITLoaderGDB.h>

#include <mutex>

// LLVM defines both; another definition of ours would be a second list.
// NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" jit_descriptor __jit_debug_descriptor;
extern "C" void __jit_debug_register_code();
// NOLINTEND(bugprone-reserved-identifier)

namespace voxc {
namespace {

/// Of the list.
std::mutex &listMutex() {
  static std::mutex mutex;
  return mutex;
}

/// Tells the debugger what became of an entry, which is or was in the list.
void tell(jit_actions_t action, jit_code_entry &entry) {
  __jit_debug_descriptor.action_flag = action;
  __jit_debug_descriptor.relevant_entry = &entry;
  __jit_debug_register_code();
  __jit_debug_descriptor.action_flag = JIT_NOACTION;
  __jit_debug_descriptor.relevant_entry = nullptr;
}

} // namespace

struct DebuggerEntries::Entry {
  jit_code_entry code;
};

DebuggerEntries::DebuggerEntries() = default;
DebuggerEntries::~DebuggerEntries() { withdraw(); }

void DebuggerEntries::add(const char *object, std::size_t bytes) {
  const std::lock_guard lock(listMutex());
  jit_code_entry *const first = __jit_debug_descriptor.first_entry;
  jit_code_entry &added = entries_.emplace_back(new Entry{{first, nullptr, object, bytes}})->code;
  if (first)
    first->prev_entry = &added;
  __jit_debug_descriptor.first_entry = &added;
  tell(JIT_REGISTER_FN, added);
}

void DebuggerEntries::withdraw() {
  const std::lock_guard lock(listMutex());
  for (const std::unique_ptr<Entry> &entry : entries_) {
    jit_code_entry &code = entry->code;
    (code.prev_entry ? code.prev_entry->next_entry : __jit_debug_descriptor.first_entry) = code.next_entry;
    if (code.next_entry)
      code.next_entry->prev_entry = code.prev_entry;
    tell(JIT_UNREGISTER_FN, code);
  }
  entries_.clear();
}

} // namespace voxc
