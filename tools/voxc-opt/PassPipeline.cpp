// Pipelines as text.
#include "PassPipeline.h"

#include "voxc/Passes/Pass.h"

#include <algorithm>

namespace voxc::tool {
namespace {

std::vector<const PlanPass *> allOfPlans() {
  std::vector<const PlanPass *> all;
  for (const PlanPass &pass : planPasses())
    all.push_back(&pass);
  return all;
}

std::string_view withoutBlanks(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\n"), text.size());
  return text.substr(begin, text.find_last_not_of(" \t\n") + 1 - begin);
}

/// Up to the next comma that stands outside of braces.
std::string_view firstPass(std::string_view text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += (text[i] == '{') - (text[i] == '}');
    if (text[i] == ',' && depth <= 0)
      return text.substr(0, i);
  }
  return text;
}

Error misplaced(std::string_view pass, const char *where) {
  return Error::usage("pass '" + std::string(pass) + "' " + where);
}

Expected<void> addPass(PassPipeline &pipeline, const std::string &written) {
  if (findPass(written)) {
    const auto text = VOXC_TRY(passText(written));
    if (pipeline.lowers || !pipeline.ofPlans.empty())
      return misplaced(text, "runs over formats, and stands behind lower or a pass over plans");
    pipeline.ofFormats.push_back(text);
    return {};
  }
  const std::string name = written.ends_with("{}") ? written.substr(0, written.size() - 2) : written;
  const PlanPass *const pass = findPlanPass(name);
  if (!pass && name != kLowering)
    return Error::usage("'" + written + "' is no pass; --print-passes lists them, with their options");
  if (!pass && (pipeline.lowers || !pipeline.ofPlans.empty()))
    return misplaced(kLowering, "stands behind a pass over plans, or behind itself");
  if (pass && !pipeline.ofFormats.empty() && !pipeline.lowers)
    return misplaced(name, "runs over plans; write lower before it");
  if (pass)
    pipeline.ofPlans.push_back(pass);
  pipeline.lowers = pipeline.lowers || !pass;
  return {};
}

} // namespace

std::vector<std::string_view> PassPipeline::names() const {
  std::vector<std::string_view> names;
  names.reserve(ofFormats.size() + ofPlans.size() + 1);
  for (const std::string &pass : ofFormats)
    names.push_back(findPass(pass)->name);
  if (lowers)
    names.push_back(kLowering);
  for (const PlanPass *pass : ofPlans)
    names.push_back(pass->name);
  return names;
}

std::string PassPipeline::text() const {
  std::string text;
  const auto append = [&text](std::string_view pass) {
    text += (text.empty() ? "" : ",") + std::string(pass);
  };
  std::ranges::for_each(ofFormats, append);
  if (lowers)
    append(kLowering);
  for (const PlanPass *pass : ofPlans)
    append(pass->name);
  return text;
}

Expected<PassPipeline> parsePipeline(std::string_view text) {
  PassPipeline pipeline{.isText = true};
  for (bool isLast = withoutBlanks(text).empty(); !isLast;) {
    const std::string_view pass = firstPass(text);
    if (withoutBlanks(pass).empty())
      return Error::usage("the pipeline has a comma with no pass beside it");
    VOXC_TRY(addPass(pipeline, std::string(withoutBlanks(pass))));
    isLast = pass.size() == text.size();
    text.remove_prefix(std::min(pass.size() + 1, text.size()));
  }
  return pipeline;
}

Expected<PassPipeline> pipelineOf(const std::vector<std::string> &ofFormats, bool lowers) {
  PassPipeline pipeline{.lowers = lowers};
  for (const std::string &name : ofFormats) {
    const auto text = VOXC_TRY(passText(name));
    pipeline.ofFormats.push_back(text);
  }
  if (lowers)
    pipeline.ofPlans = allOfPlans();
  return pipeline;
}

Expected<PassPipeline> pipelineFor(PassPipeline pipeline, bool isPlan) {
  if (isPlan && !pipeline.ofFormats.empty())
    return misplaced(pipeline.ofFormats.front(), "runs over formats, and the input is a plan");
  if (isPlan && pipeline.isText && pipeline.lowers)
    return misplaced(kLowering, "makes a plan of a format, and the input is a plan");
  if (!isPlan && !pipeline.lowers && !pipeline.ofPlans.empty())
    return misplaced(pipeline.ofPlans.front()->name, "runs over plans; write lower before it");
  if (isPlan && !pipeline.isText)
    pipeline.ofPlans = allOfPlans();
  pipeline.lowers = pipeline.lowers && !isPlan;
  return pipeline;
}

} // namespace voxc::tool
