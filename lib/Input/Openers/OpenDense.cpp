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
  auto volume = VOXC_TRY(usable(read(std::move(file)), path, std::string(kind) + " file"));
  auto input = VOXC_TRY(makeInput(std::move(volume), options));
  if (!options.grid.empty())
    input.provenance += " grid=" + provenanceWord(options.grid);
  input.loadSeconds = loading.seconds();
  return input;
}

} // namespace voxc
