// What voxc-opt does around passes: one instrumentation for those of both IRs, in the words of opt and
// mlir-opt.
#pragma once

#include "common/CommandLine.h"
#include "voxc/Support/Error.h"

#include <functional>
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

/// One run of a pass.
struct PassReport {
  std::string_view pass;
  bool changed = false;
  double seconds = 0;
  std::size_t changedParts = 0; ///< Levels or strata.
  std::string why;              ///< It changed nothing.
};

class Instrumentation {
public:
  /// The IR as text, made where it is asked for.
  using Printed = std::function<std::string()>;

  explicit Instrumentation(const InstrumentationOptions &options) : options_(options) {}

  /// Error: an option names no pass of these.
  Expected<void> check(const std::vector<std::string_view> &passes) const;

  /// Before a pass. False if it is to be left out: the pipeline has stopped, or the limit is reached.
  bool begin(std::string_view pass, const Printed &ir);
  /// After it.
  void end(const PassReport &report, const Printed &ir);
  bool hasStopped() const { return hasStopped_; }

  /// Tables and remarks. Error: the file of remarks cannot be written.
  Expected<void> finish() const;

private:
  bool keepsRemark(const PassReport &report) const;

  const InstrumentationOptions &options_;
  bool hasStopped_ = false;
  unsigned begun_ = 0;
  std::vector<PassReport> reports_;
};

} // namespace voxc::tool
