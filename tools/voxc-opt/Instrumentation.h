// What voxc-opt does around passes: one instrumentation for those of both IRs, in the words of opt and
// mlir-opt.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/PassManager.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

inline constexpr unsigned kNoLimit = ~0u;

struct InstrumentationOptions {
  std::vector<std::string> printBefore, printAfter; ///< Names of passes.
  bool printBeforeAll = false;
  bool printAfterAll = false;
  bool printChanged = false; ///< After those that change something alone.
  bool timePasses = false;
  bool statistics = false;
  std::vector<std::string> remarks; ///< Kinds of them: applied, missed.
  std::string remarksFile;          ///< As JSON; "": as text on standard error.
  std::string stopBefore, stopAfter;
  unsigned bisectLimit = kNoLimit; ///< So many of the first passes are run; all by default.

  void declare(const CommandLine &command);
};

class Instrumentation {
public:
  explicit Instrumentation(const InstrumentationOptions &options) : options_(options) {}

  /// Error: an option names no pass of these.
  Expected<void> check(const std::vector<std::string_view> &passes) const;

  /// Before each input, which begins with this word. Remarks go to `remarks` if it is there, else they are
  /// printed.
  void beginInput(const SourceText &source, SourceRange begin, std::vector<Diagnostic> *remarks);

  /// What looks on while passes run; this must outlive it.
  PipelineOptions hooks();

  /// Tables and remarks. Error: the file of remarks cannot be written.
  Expected<void> finish() const;

private:
  struct Remark {
    std::string_view kind, pass;
    std::string message, file;
    std::size_t line;
  };

  bool begin(std::string_view pass, PrintedIr ir);
  void end(const PassReport &report, PrintedIr ir);
  void remark(const PassReport &report);

  const InstrumentationOptions &options_;
  bool hasStopped_ = false;
  unsigned begun_ = 0;
  const SourceText *source_ = nullptr;
  SourceRange begin_;
  std::vector<Diagnostic> *found_ = nullptr;
  std::vector<PassReport> reports_;
  std::vector<Remark> remarks_;
};

} // namespace voxc::tool
