// Opening dense volumes, whatever reads them.
#include "Input/Openers/OpenDense.h"

#include "Input/Openers/InputText.h"
#include "voxc/Support/Stopwatch.h"

#include <utility>

namespace voxc {

Expected<Input> openDense(const std::string &path, std::string_view kind, const InputOptions &options,
                          ReadDense read) {
  const Stopwatch loading;
  auto file = VOXC_TRY(WatchedFile::open(path, options.memory));
  auto volume = read(std::move(file));
  if (!volume && volume.error().kind == ErrorKind::Input)
    return Error::input("'" + path + "' is not a usable " + std::string(kind) +
                        " file: " + volume.error().message);
  if (!volume)
    return volume.error();
  auto input = VOXC_TRY(makeInput(std::move(*volume), options));
  if (!options.grid.empty())
    input.provenance += " grid=" + provenanceWord(options.grid);
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
