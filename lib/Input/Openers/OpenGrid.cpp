// Opening dense grids of words.
#include "Input/Openers/Openers.h"

#include "Input/Openers/InputText.h"
#include "Source/GridExtent.h"
#include "voxc/Source/Sources.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

/// `text` is "WxHxD:FILE".
Expected<Input> openGrid(const std::string &text, const InputOptions &options) {
  const Stopwatch loading;
  const std::size_t colon = text.find(':');
  const auto extent = parseExtent(std::string_view(text).substr(0, colon));
  if (!extent || colon == std::string::npos)
    return Error::input("'grid:" + text +
                        "' is not a grid; write its size and file as in grid:64x33x32:FILE.raw");
  auto source = VOXC_TRY(loadGridSource(*extent, text.substr(colon + 1), options.memory, options.progress));
  Input input;
  input.source = std::move(source);
  input.loadSeconds = loading.seconds();
  input.provenance = "grid=" + extentText(*extent);
  return input;
}

} // namespace voxc
