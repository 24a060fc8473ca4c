// Opening files of nothing but samples.
#include "Input/Openers/Openers.h"

#include "Input/Dense/DenseVolume.h"
#include "Input/Openers/InputText.h"
#include "Source/GridExtent.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

namespace {

Expected<DenseVolume> readVolume(const std::string &path, Int3 extent, SampleLayout layout,
                                 const InputOptions &options) {
  const auto size = VOXC_TRY(sampleBytes(extent, layout));
  auto file = VOXC_TRY(WatchedFile::open(path, options.memory));
  const std::uint64_t bytes = file->bytes().size();
  if (bytes != size)
    return Error::input("'" + path + "' has " + std::to_string(bytes) + " bytes, but a grid of " +
                        extentText(extent) + " such samples has " + std::to_string(size));
  DenseVolume volume;
  volume.extent = extent;
  volume.layout = layout;
  volume.samples = file->bytes().data();
  volume.storage = std::move(file);
  return volume;
}

} // namespace

/// `text` is "WxHxD:TYPE:FILE".
Expected<Input> openRaw(const std::string &text, const InputOptions &options) {
  const Stopwatch loading;
  const std::string_view view = text;
  const std::size_t first = view.find(':');
  const std::size_t second = first == std::string_view::npos ? first : view.find(':', first + 1);
  const auto extent = parseExtent(view.substr(0, first));
  if (!extent || second == std::string_view::npos)
    return Error::input("'raw:" + text +
                        "' is no volume; write its size, type and file as in raw:64x33x32:uint8:FILE.raw");
  const std::string type = text.substr(first + 1, second - first - 1);
  const auto layout = parseSampleLayout(type);
  if (!layout)
    return Error::input("'" + type + "' is no type of samples; there are " + sampleLayoutNames());
  auto volume = VOXC_TRY(readVolume(text.substr(second + 1), *extent, *layout, options));
  auto input = makeInput(std::move(volume), options);
  if (input)
    input->loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
