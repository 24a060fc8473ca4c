// Measuring the colours of an input, and the first payload that a format takes.
#include "PayloadOption.h"

namespace voxc::tool {

namespace {

/// `from` has been given how a kernel goes through the format; that stays.
void keepWalk(const Format &from, Format &format) {
  for (const AttributeKind *kind : formatAttributes())
    if (kind->effect == AttributeEffect::Walk)
      format.setAttribute(*kind, from.attributes.value(*kind));
}

} // namespace

void PayloadOption::declare(const CommandLine &command) {
  command
      .add("--payload", payload_,
           "What voxels keep: auto, the smallest payload that keeps all colours of the input")
      .takes("auto")
      .oneOf({"auto"});
}

Expected<void> PayloadOption::apply(Format &format, const Form &form, VoxelSource &source,
                                    const std::shared_ptr<WorkingMemory> &memory, const Progress &progress,
                                    Json &figures) const {
  if (const std::string payload(format.attributes.value(kPayloadAttribute));
      payload != kPayloadAttribute.values.front())
    return Error::usage("--payload auto would choose what is chosen already, payload=" + payload +
                        "; leave out one of both");
  const std::unique_ptr<VoxelSource> view = source.view();
  const auto facts = measureFacts(view ? *view : source, {.memory = memory}, progress);
  if (!facts)
    return facts.error();
  std::string refused;
  for (const PayloadChoice &choice : choosePayload(*facts)) {
    Expected<Format> formed = form(choice);
    if (!formed) {
      refused = "; nothing smaller, since " + formed.error().message;
      continue;
    }
    keepWalk(format, *formed);
    format = std::move(*formed);
    figures["payload"] = choice.payload + (choice.apart ? ", values apart" : "");
    figures["payload_why"] = choice.why + refused;
    return {};
  }
  return {};
}

} // namespace voxc::tool
