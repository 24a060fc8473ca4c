// Measuring the colours of an input, and the first payload that a format takes.
#include "building/PayloadOption.h"

#include "voxc/Passes/Pass.h"

namespace voxc::tool {

namespace {

/// Gives what pays beside short pointers. Returns the names of what was given, to follow a payload, each
/// after a comma.
std::string addBesidePointers(Format &format) {
  std::string given;
  for (const Pass &pass : passes()) {
    Diagnostics notes; // It need not apply.
    if (pass.besidePointers && pass.run(format, notes) == PassResult::Changed)
      given += ", " + std::string(pass.name);
  }
  return given;
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
    const std::string given = addBesidePointers(*formed);
    format = std::move(*formed);
    figures["payload"] = choice.payload + (choice.apart ? ", values apart" : "") + given;
    figures["payload_why"] = choice.why + refused;
    return {};
  }
  return {};
}

} // namespace voxc::tool
