// Generated code for edits, compiled, and a run of it.
#pragma once

#include "EditHost.h"

#include "Jit/Jit.h"
#include "voxc/Support/CompileCache.h"

#include <cstddef>
#include <memory>

namespace voxc {

/// Code that edits volumes of one format.
class EditCode {
public:
  /// Errors: the format's layout cannot be edited; the compiler's.
  static Expected<EditCode> compile(const Format &format, const CompileCache *cache);

  /// Begins a run of edits with a host, which outlives it.
  void begin(EditHost &host);
  /// Does the edit that the host has; returns what leads to the root. Only the store says whether it failed.
  Ref edit(Ref root) { return edit_(run_.get(), root); }

private:
  using Bytes = construct::uint64_t (*)();
  using Begin = void (*)(void *run, const construct::Host *host, const construct::EditHost *edits);
  using Edit = std::uint32_t (*)(void *run, std::uint32_t root);

  explicit EditCode(JitCode code) : code_(std::move(code)) {}

  JitCode code_;
  Bytes bytes_ = nullptr;
  Begin begin_ = nullptr;
  Edit edit_ = nullptr;
  std::unique_ptr<std::byte[]> run_; ///< Memory of the generated code's own.
};

} // namespace voxc
