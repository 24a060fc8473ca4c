// Diagnostics that comments of an input expect, in the words of MLIR: `// expected-error @+1 {{message}}`.
#pragma once

#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/Error.h"

#include <span>
#include <string>
#include <vector>

namespace voxc::tool {

class ExpectedDiagnostics {
public:
  /// Reads the comments of a text. Error: one begins as an expectation does and is none.
  static Expected<ExpectedDiagnostics> read(const SourceText &source);

  /// Compares what is expected with what was found. Error: an expected one was not found, or one that was
  /// found is not expected; each has a message at its place.
  Expected<void> compare(std::span<const Diagnostic> found) const;

private:
  struct Expectation {
    Severity severity;
    std::size_t line; ///< On which it is expected.
    std::string text; ///< A part of its message.
    SourceRange range;
  };
  friend class ExpectationReader;

  explicit ExpectedDiagnostics(const SourceText &source) : source_(source) {}

  const SourceText &source_;
  std::vector<Expectation> expected_;
};

} // namespace voxc::tool
