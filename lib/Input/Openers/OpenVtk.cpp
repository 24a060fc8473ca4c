// Opening VTK's image data: XML files (.vti).
#include "Input/Openers/Openers.h"

#include "Input/Openers/InputText.h"
#include "Input/Vtk/VtkImage.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

namespace {

Expected<DenseVolume> readFile(std::shared_ptr<const WatchedFile> source, const InputOptions &options) {
  const auto file = readVtiFile(source->text(), options.progress);
  if (!file)
    return file.error();
  return readVtkImage(*file, std::move(source), options);
}

} // namespace

Expected<Input> openVtk(const std::string &path, const InputOptions &options) {
  const Stopwatch loading;
  auto source = WatchedFile::open(path, options.memory);
  if (!source)
    return source.error();
  auto volume = readFile(std::move(*source), options);
  if (!volume && volume.error().kind == ErrorKind::Input)
    return Error::input("'" + path + "' is not a usable VTK file: " + volume.error().message);
  if (!volume)
    return volume.error();
  auto input = makeInput(std::move(*volume), options);
  if (!input)
    return input;
  if (!options.grid.empty())
    input->provenance += " grid=" + provenanceWord(options.grid);
  input->loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
