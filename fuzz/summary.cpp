// Fuzzes what `voxc info` reads of a .hvx file, its head alone: it must be what the whole file says too, and
// the head's text with the record of words must come back from itself.
#include "Expect.h"
#include "FuzzedFile.h"
#include "RightChecksums.h"
#include "WordMutator.h"

#include "Volume/WordRecord.h"
#include "voxc/Volume/VolumeSummary.h"

namespace {

using namespace voxc;
using fuzz::expect;

void expectRecord(const VolumeInfo &info) {
  const std::string text = textWithRecord(info);
  VolumeInfo again = info;
  again.wordCounts.reset();
  readRecord(text, again);
  expect(textWithRecord(again) == text && again.provenance == info.provenance);
}

void expectSame(const VolumeSummary &summary, const Volume &volume) {
  expect(volume.format() == summary.info.format && volume.info().voxels == summary.info.voxels &&
         volume.info().extent == summary.info.extent && volume.info().provenance == summary.info.provenance);
  expect(volume.streams().size() == summary.streams.size() && volume.bytes() == summary.bytes());
  for (std::size_t i = 0; i < summary.streams.size(); ++i) {
    const Stream &stream = volume.streams()[i];
    expect(stream.name == summary.streams[i].name && stream.elements() == summary.streams[i].elements());
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::vector<std::byte> bytes = fuzz::withRightChecksums(data, size);
  const std::string path =
      fuzz::folder().write("a.hvx", {reinterpret_cast<const char *>(bytes.data()), bytes.size()});
  const auto summary = summarizeVolume(path);
  const auto volume = Volume::load(path);
  expect(summary || !volume);
  if (summary) {
    expect(summary->storedBytes() <= bytes.size() && !summary->streams.empty());
    expectRecord(summary->info);
  }
  if (volume)
    expectSame(*summary, *volume);
  return 0;
}
