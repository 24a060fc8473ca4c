// Running passes over an IR, whichever it is: in order, each watched, and followed by the verifier.
#pragma once

#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/Error.h"
#include "voxc/Support/FunctionRef.h"
#include "voxc/Support/Stopwatch.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace voxc {

/// What passes ask of an IR. A specialisation has
/// - `kName`: what the IR is called in messages;
/// - `verify(ir, diagnostics)`;
/// - `print(ir)`: its text;
/// - `changedParts(before, after)`: the places of the levels, or of what else it has, that differ;
/// - `errorAt(ir, diagnostics)`: what a pass found wrong, at its places in the text that the IR was read
/// from.
template <typename Ir> struct IrTraits;

/// One run of a pass, for those who watch.
struct PassReport {
  std::string_view pass;
  bool changed = false;
  double seconds = 0;
  std::vector<SourceRange> changedParts; ///< Where what it changed was written; none: the IR as a whole.
  std::string why;                       ///< It changed nothing.
};

/// The IR as text, made where it is asked for.
using PrintedIr = FunctionRef<std::string()>;

/// How passes are run, and who watches. What is empty is not called.
struct PipelineOptions {
  bool verifyEach = true;
  /// Called before each pass; it is left out if that is false.
  std::function<bool(std::string_view pass, PrintedIr)> beforeEach;
  std::function<void(const PassReport &, PrintedIr)> afterEach;
  /// What a pass, or the verifier after it, finds wrong, before it is made an error.
  std::function<void(const Diagnostics &)> onErrors;
};

/// Passes over one IR, in the order in which they are added.
template <typename Ir> class PassManager {
public:
  /// A pass. Notes say why it changes nothing; with errors the IR stays as it is.
  using Run = std::function<void(Ir &, Diagnostics &)>;

  /// Adds a pass; the name must outlive this.
  void add(std::string_view name, Run run) { passes_.push_back({name, std::move(run)}); }

  /// Runs all. Errors: what a pass finds wrong; that one left an IR which the verifier refuses, a defect of
  /// voxc.
  Expected<void> run(Ir &ir, const PipelineOptions &options) const {
    for (const Pass &pass : passes_)
      VOXC_TRY(runPass(pass, ir, options));
    return {};
  }

private:
  using Traits = IrTraits<Ir>;
  struct Pass {
    std::string_view name;
    Run run;
  };

  static Expected<void> runPass(const Pass &pass, Ir &ir, const PipelineOptions &options) {
    const auto printed = [&ir] { return Traits::print(ir); };
    if (options.beforeEach && !options.beforeEach(pass.name, printed))
      return {};
    Diagnostics diagnostics;
    if (!options.afterEach)
      pass.run(ir, diagnostics);
    else if (const PassReport report = watch(pass, ir, diagnostics); !diagnostics.hasErrors())
      options.afterEach(report, printed);
    if (diagnostics.hasErrors()) {
      if (options.onErrors)
        options.onErrors(diagnostics);
      return Traits::errorAt(ir, diagnostics);
    }
    return options.verifyEach ? verifyAfter(pass.name, ir, options) : Expected<void>();
  }

  /// Runs a pass and finds out what it did, which takes a copy of the IR.
  static PassReport watch(const Pass &pass, Ir &ir, Diagnostics &diagnostics) {
    const Ir before = ir;
    const Stopwatch watch;
    pass.run(ir, diagnostics);
    PassReport report{.pass = pass.name, .seconds = watch.seconds()};
    report.changed = !(before == ir);
    if (report.changed)
      report.changedParts = Traits::changedParts(before, ir);
    else
      report.why =
          diagnostics.all().empty() ? "what it chooses is there already" : diagnostics.all().front().message;
    return report;
  }

  static Expected<void> verifyAfter(std::string_view pass, const Ir &ir, const PipelineOptions &options) {
    Diagnostics diagnostics;
    Traits::verify(ir, diagnostics);
    if (!diagnostics.hasErrors())
      return {};
    if (options.onErrors)
      options.onErrors(diagnostics);
    return Error::environment("the pass " + std::string(pass) + " left a wrong " +
                              std::string(Traits::kName) +
                              ", a defect of voxc: " + diagnostics.all().front().message);
  }

  std::vector<Pass> passes_;
};

/// Runs the step from one IR to the next, which those who watch see as a pass. Nothing if it is left out.
template <typename From, typename To>
std::optional<To> runLowering(std::string_view name, const From &from, FunctionRef<To(const From &)> lower,
                              const PipelineOptions &options) {
  if (options.beforeEach && !options.beforeEach(name, [&from] { return IrTraits<From>::print(from); }))
    return {};
  const Stopwatch watch;
  To to = lower(from);
  const double seconds = watch.seconds();
  if (options.afterEach)
    options.afterEach({.pass = name,
                       .changed = true,
                       .seconds = seconds,
                       .changedParts = IrTraits<To>::changedParts({}, to)},
                      [&to] { return IrTraits<To>::print(to); });
  return to;
}

} // namespace voxc
