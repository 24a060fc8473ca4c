// Opening built-in scenes.
#include "Input/Openers/Openers.h"

#include "Input/Openers/InputText.h"
#include "Source/ClippedSource.h"
#include "voxc/Source/Sources.h"

#include <utility>

namespace voxc {

/// `text` is "NAME" or "NAME:N".
Expected<Input> openBuiltin(const std::string &text, const InputOptions &options) {
  const std::size_t colon = text.find(':');
  const bool hasSide = colon != std::string::npos;
  const auto written = hasSide ? parseCount(std::string_view(text).substr(colon + 1)) : std::nullopt;
  if (hasSide && !written)
    return Error::input("'" + text.substr(colon + 1) +
                        "' is not a size; write builtin:NAME:N with N voxels an axis");
  const bool isChosen = hasSide || options.resolution > 0;
  const int side =
      written.value_or(options.resolution > 0 ? options.resolution : longestAxis(options.formatExtent));
  const std::string name = text.substr(0, colon);
  auto source = VOXC_TRY(makeBuiltinSource(name, side));
  Input input;
  // Nobody asked for the size of a scene that merely fills the format, so what reaches over it is cut off.
  input.source = isChosen ? std::move(source) : clip(std::move(source), options.formatExtent);
  input.provenance = "builtin=" + name + ":" + std::to_string(side);
  if (options.describe)
    input.facts = {{"scene", name, {}}, countFact("resolution", static_cast<std::uint64_t>(side))};
  return input;
}

} // namespace voxc
