// Attribute options, generated from the table of attributes.
#include "frontend/AttributeOptions.h"

#include "voxc/IR/Query.h"

#include <algorithm>

namespace voxc::tool {

namespace {

template <typename Texts> std::string joined(const Texts &texts, std::string_view separator) {
  std::string text;
  for (const std::string_view one : texts)
    text += (text.empty() ? "" : std::string(separator)) + std::string(one);
  return text;
}

/// The attributes of a list; only those that are listed by default, if `isDefault`.
std::vector<std::string> namesOf(const AttributeList &list, bool isDefault) {
  std::vector<std::string> names;
  for (const AttributeKind *kind : formatAttributes())
    if (kind->list == &list && (!isDefault || kind->values.front() == "yes"))
      names.emplace_back(kind->name);
  return names;
}

} // namespace

void AttributeOptions::declare(const CommandLine &command) {
  const OptionGroup group(command, "Kernel");
  for (const AttributeKind *kind : formatAttributes()) {
    if (kind->effect == AttributeEffect::Storage) // Passes set those.
      continue;
    if (kind == &kBoundsAttribute) // Who has rays knows; --bounds is that of a model.
      continue;
    if (kind->list) {
      if (!listed_.contains(kind->list))
        declareList(command, *kind->list);
      continue;
    }
    if (!kind->byPasses.empty()) {
      command.addFormer("--" + std::string(kind->name), std::string(kind->byPasses));
      continue;
    }
    const std::vector<std::string> values(kind->values.begin(), kind->values.end());
    command.add("--" + std::string(kind->name), values_[kind], std::string(kind->summary))
        .takes(joined(values, "|") + "=" + values.front())
        .oneOf(values);
  }
}

void AttributeOptions::declareList(const CommandLine &command, const AttributeList &list) {
  const std::vector<std::string> names = namesOf(list, false);
  command
      .add("--" + std::string(list.name), listed_[&list],
           std::string(list.summary) + "; of " + joined(names, ", "))
      .takes("A,B=" + joined(namesOf(list, true), ","))
      .list()
      .oneOf(names);
}

void AttributeOptions::declareBounds(const CommandLine &command) {
  const OptionGroup group(command, "Kernel");
  command.addFlag("--ray-bounds", bounds_,
                  "Each ray has bounds, a tmin and a tmax, between which the kernel looks for voxels");
}

Expected<void> AttributeOptions::apply(Format &format) const {
  for (const auto &[kind, value] : values_)
    if (!value.empty())
      format.setAttribute(*kind, value);
  if (bounds_)
    askForBounds(format);
  for (const auto &[list, names] : listed_)
    for (const AttributeKind *kind : formatAttributes())
      if (kind->list == list && !names.empty())
        format.setAttribute(*kind, std::ranges::find(names, kind->name) != names.end() ? "yes" : "no");
  // Defaults can be listed too, and leaves no trace in the format.
  const bool lists = std::ranges::any_of(listed_, [](const auto &entry) { return !entry.second.empty(); });
  if (lists && !isOfHits(questionOf(format).query))
    return Error::usage("--outputs chooses what --query closest stores; another query leaves no choice");
  if (const std::string_view problem = problemOfQuestion(format); !problem.empty())
    return Error::usage("the format " + std::string(problem));
  return {};
}

} // namespace voxc::tool
