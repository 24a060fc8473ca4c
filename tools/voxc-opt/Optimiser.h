// What voxc-opt does to an input, or to each part of one.
#pragma once

#include "Instrumentation.h"
#include "PassPipeline.h"

#include "voxc/Support/Diagnostic.h"
#include "voxc/Support/Error.h"

#include <string>
#include <vector>

namespace voxc::tool {

struct OptimiserOptions {
  bool verifyEach = true;
  bool splits = false;              ///< Parts are run one by one.
  bool verifiesDiagnostics = false; ///< Comments of the input say which diagnostics there are.
};

class Optimiser {
public:
  /// All must outlive this.
  Optimiser(const OptimiserOptions &options, const PassPipeline &pipeline, Instrumentation &instrumentation)
      : options_(options), pipeline_(pipeline), instrumentation_(instrumentation) {}

  /// Runs the pipeline and appends what comes out to `output`, of every part that is right. Error: that of
  /// the first that is wrong, with those of others of its kind behind it.
  Expected<void> run(const SourceText &input, std::string &output);

private:
  Expected<void> runPart(const SourceText &part, std::string &output);
  /// As runPart, where diagnostics are expected.
  Expected<void> runExpecting(const SourceText &part, std::string &output);
  /// The text that comes out; diagnostics go to `found_` as well.
  Expected<std::string> optimise(const SourceText &part);
  Expected<std::string> optimiseFormat(const SourceText &part, const PassPipeline &pipeline);
  Expected<std::string> optimisePlan(Plan plan, const PassPipeline &pipeline);
  PipelineOptions passOptions();
  void keep(const Diagnostics &diagnostics);

  const OptimiserOptions &options_;
  const PassPipeline &pipeline_;
  Instrumentation &instrumentation_;
  std::vector<Diagnostic> found_; ///< In the part at hand.
};

} // namespace voxc::tool
