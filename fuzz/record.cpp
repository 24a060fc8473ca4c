// Fuzzes the records of `voxc bench`, lines of JSON: what is read must come back from its own line.
#include "FuzzedFile.h"

#include "bench/Record.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const auto record = voxc::tool::bench::parseRecord(voxc::fuzz::textOf(data, size));
  if (!record)
    return 0;
  const std::string line = voxc::tool::bench::toJson(*record).dump();
  const auto again = voxc::tool::bench::parseRecord(line);
  if (!again || voxc::tool::bench::toJson(*again).dump() != line)
    std::abort();
  return 0;
}
