// Fuzzes the records of `voxc bench`, lines of JSON: what is read must come back from its own line.
#include "FuzzedFile.h"

#include "voxc/Measure/Record.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const auto record = voxc::measure::parseRecord(voxc::fuzz::textOf(data, size));
  if (!record)
    return 0;
  const std::string line = voxc::measure::toLine(*record);
  const auto again = voxc::measure::parseRecord(line);
  if (!again || voxc::measure::toLine(*again) != line)
    std::abort();
  return 0;
}
