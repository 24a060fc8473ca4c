// Which passes run over an input: those of a format, the step to a plan, and those of a plan.
#pragma once

#include "voxc/Plan/Plan.h"
#include "voxc/Support/Error.h"

#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

struct PassPipeline {
  std::vector<std::string> ofFormats; ///< Each as `passText` gives it.
  bool lowers = false;
  std::vector<const PlanPass *> ofPlans;
  bool isText = false; ///< It was written as a text, and has no pass that is not there.

  /// The names of all passes in it, without their options.
  std::vector<std::string_view> names() const;

  /// Its text, which `parsePipeline` reads: "merge-grids,short-pointers{bits=20},lower,choose-traversal".
  std::string text() const;
};

/// Reads the text of a pipeline. Error `Usage`: an unknown pass or option, or one on the wrong side of
/// `lower`.
Expected<PassPipeline> parsePipeline(std::string_view text);

/// The pipeline that flags choose: these passes, and all passes over plans if it goes on to a plan.
Expected<PassPipeline> pipelineOf(const std::vector<std::string> &ofFormats, bool lowers);

/// The pipeline as it runs over an input: one of flags runs all passes over a plan. Error `Usage`: some pass
/// runs over the other IR.
Expected<PassPipeline> pipelineFor(PassPipeline pipeline, bool isPlan);

} // namespace voxc::tool
