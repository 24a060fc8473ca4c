// From attributes to what a kernel answers.
#include "voxc/IR/Query.h"

#include "voxc/IR/Choices.h"

#include <algorithm>
#include <utility>

namespace voxc {
namespace {

/// The attribute that chooses each output.
constexpr std::pair<const TypedAttribute<bool> *, bool Outputs::*> kOutputs[] = {
    {&kVoxelAttribute, &Outputs::voxel},
    {&kTAttribute, &Outputs::t},
    {&kFaceAttribute, &Outputs::face},
    {&kColourAttribute, &Outputs::colour},
    {&kIndexAttribute, &Outputs::index}};

} // namespace

Question questionOf(const Format &format) {
  Question question{format.attributes.get(kQueryAttribute), {}};
  question.bounds = format.attributes.get(kBoundsAttribute);
  question.outputs = outputsOf(question.query);
  for (const auto &[kind, output] : kOutputs)
    if (format.attributes.value(*kind) != kind->values.front())
      question.outputs.*output = format.attributes.get(*kind);
  return question;
}

void askForBounds(Format &format) { format.setAttribute(kBoundsAttribute, "yes"); }

void askForCones(Format &format, bool stops) {
  format.setAttribute(kDetailAttribute, toString(stops ? Detail::Cone : Detail::Full));
}

void askForPrecision(Format &format, std::string_view precision) {
  format.setAttribute(kPrecisionAttribute, precision);
}

std::span<const std::string_view> precisionNames() { return kPrecisionAttribute.values; }

std::string_view problemOf(const Question &question) {
  const bool isClosest = isOfHits(question.query);
  if (question.bounds && isOfPoints(question.query))
    return "gives bounds to points, of which rays alone have any; leave out bounds=yes, or the query";
  if (!isClosest && question.outputs != outputsOf(question.query))
    return "chooses outputs, which query=closest alone has; leave them out, or the query";
  if (question.outputs.colour && question.outputs.index)
    return "stores both colour and index, which have one place in a hit; choose one";
  const bool storesNone =
      std::ranges::none_of(kOutputs, [&](const auto &output) { return question.outputs.*output.second; });
  return isClosest && storesNone ? "has no output; query=any asks whether there is a hit at all"
                                 : std::string_view();
}

std::string_view problemOfQuestion(const Format &format) {
  const Question question = questionOf(format);
  const AttributeKind &ranked = *kIndexAttribute.needs;
  const bool areRanked = format.attributes.value(ranked) != ranked.values.front();
  if (question.bounds && format.attributes.get(kDetailAttribute) != Detail::Full)
    return "stops above voxels, whose bounds cannot be decided there; leave out bounds=yes, or detail=cone";
  if (question.outputs.index && (!areRanked || format.attributes.get(kDetailAttribute) != Detail::Full))
    return "asks for the numbers of voxels, which levels count with values=apart, and whose cubes have none; "
           "build with --values-apart, and leave out detail=cone";
  return problemOf(question);
}

} // namespace voxc
