// Measuring the colours of an input, and the first payload that a format takes.
#include "PayloadOption.h"

#include "voxc/Passes/Pass.h"

#include <array>

namespace voxc::tool {

namespace {

/// Makes any format smaller that it applies to, whatever the colours are.
const std::array<std::string, 1> kPassesOfAll = {"octant-counts"};

bool countsOctants(const Format &format) {
  return format.levels.back().attribute(kCountsAttribute) == "octant";
}

} // namespace

void PayloadOption::declare(const CommandLine &command) {
  command
      .add("--payload", payload_,
           "What voxels keep: auto, the smallest payload that keeps all colours of the input")
      .takes("auto")
      .oneOf({"auto"});
}

Expected<void> PayloadOption::check(const Format &format) const {
  if (const std::string payload(format.attributes.value(kPayloadAttribute));
      payload != kPayloadAttribute.values.front())
    return Error::usage("--payload auto would choose what is chosen already, payload=" + payload +
                        "; leave out one of both");
  return {};
}

Expected<void> PayloadOption::apply(Format &format, const Form &form, const Facts &facts,
                                    Json &figures) const {
  std::string refused;
  for (const PayloadChoice &choice : choosePayload(facts)) {
    Expected<Format> formed = form(choice);
    if (!formed) {
      refused = "; nothing smaller, since " + formed.error().message;
      continue;
    }
    if (const auto counted = runPasses(*formed, kPassesOfAll); !counted)
      return counted.error();
    format = std::move(*formed);
    figures["payload"] = choice.payload + (choice.apart ? ", values apart" : "") +
                         (countsOctants(format) ? ", counts of octants" : "");
    figures["payload_why"] = choice.why + refused;
    return {};
  }
  return {};
}

} // namespace voxc::tool
