// Fuzzes lines of rays with their exact hits (test/hard-rays): what is read must come back from its own line.
#include "FuzzedFile.h"

#include "hard-rays/HardRayCorpus.h"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const auto rays = voxc::tool::parseCorpus(voxc::fuzz::textOf(data, size), "corpus");
  if (!rays)
    return 0;
  for (const voxc::tool::CorpusRay &ray : *rays) {
    const std::string line = voxc::tool::corpusLine(ray);
    const auto again = voxc::tool::parseCorpus(line, "line");
    if (!again || again->size() != 1 || voxc::tool::corpusLine(again->front()) != line)
      std::abort();
  }
  return 0;
}
