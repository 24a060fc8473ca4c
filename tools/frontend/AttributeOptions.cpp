// Attribute options, generated from the table of attributes.
#include "frontend/AttributeOptions.h"

#include <vector>

namespace voxc::tool {

namespace {

std::string joined(std::span<const std::string_view> values) {
  std::string text;
  for (const std::string_view value : values)
    text += (text.empty() ? "" : "|") + std::string(value);
  return text;
}

} // namespace

void AttributeOptions::declare(CLI::App &app) {
  for (const AttributeKind *kind : formatAttributes()) {
    if (kind->effect == AttributeEffect::Storage) // Passes set those.
      continue;
    const std::vector<std::string> values(kind->values.begin(), kind->values.end());
    app.add_option("--" + std::string(kind->name), values_[kind], std::string(kind->summary))
        ->type_name(joined(kind->values) + "=" + values.front())
        ->check(CLI::IsMember(values).description(""));
  }
}

void AttributeOptions::apply(Format &format) const {
  for (const auto &[kind, value] : values_)
    if (!value.empty())
      format.setAttribute(*kind, value);
}

} // namespace voxc::tool
