// Opening and completing a volume.
#include "VolumeBuild.h"

#include <algorithm>
#include <array>

namespace voxc {

Expected<std::unique_ptr<VolumeBuild>> VolumeBuild::start(VolumeInfo info, const BuildOptions &options) {
  std::unique_ptr<VolumeBuild> build(new VolumeBuild(std::move(info), options));
  auto words = build->openWords();
  if (!words)
    return words.error();
  const Layout layout = layoutOf(build->info_.format);
  const std::array<std::uint32_t, 3> head = {};
  if (auto begun = words->append(std::span(head).first(layout.headWords() - words->size())); !begun)
    return begun.error();
  build->store_ = std::make_unique<NodeStore>(std::move(*words), layout, options.memory);
  build->values_ = std::make_unique<ValueStore>(*build->store_, options.memory);
  build->maxWords_ = std::min(options.maxWords, layout.maxWords());
  build->store_->limit(build->maxWords_);
  return build;
}

VolumeBuild::~VolumeBuild() {
  if (store_ && options_.wordsReached)
    *options_.wordsReached = wordsReached_ ? wordsReached_ : store_->words().size();
}

Expected<WordStore> VolumeBuild::openWords() {
  if (!options_.path.empty()) {
    auto writer = VolumeFileWriter::create(options_.path, info_);
    if (!writer)
      return writer.error();
    isStreamed_ = writer->canSettle();
    if (isStreamed_)
      writer_.emplace(std::move(*writer));
  }
  if (!isStreamed_)
    return WordStore::create(options_.memory);
  return WordStore::create(options_.memory,
                           [this](MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes) {
                             return writer_->settle(block, begin, bytes, *options_.memory);
                           });
}

/// The array of indexed sub-volumes stands behind all nodes.
void VolumeBuild::appendArray(WordStore &words) {
  const auto array = store_->array();
  if (array.empty() || store_->failure())
    return;
  if (words.size() + array.size() > maxWords_)
    return store_->fail(Error::input("the volume needs more than " + std::to_string(maxWords_) +
                                     " words, the most that it may have"));
  words.setHead(layoutOf(info_.format).headWords() - 1, static_cast<std::uint32_t>(words.size()));
  if (auto appended = words.append(array); !appended)
    store_->fail(appended.error());
}

Expected<Built> VolumeBuild::finish(std::uint32_t root, std::uint64_t voxels, std::uint32_t colour) {
  WordStore &words = store_->words();
  appendArray(words);
  const std::uint64_t nodeWords = words.size();
  const Layout layout = layoutOf(info_.format);
  if (layout.values == Values::Apart)
    values_->finish(words, maxWords_);
  if (layout.payload == Payload::Constant)
    words.setHead(1, colour);
  if (store_->failure())
    return *store_->failure();
  options_.progress.at("write", 0);
  const Stopwatch writing;
  words.setRoot(root);
  info_.voxels = voxels;
  const auto span = words.span();
  wordsReached_ = span.size();
  BuildReport report;
  report.voxels = voxels;
  report.levels = store_->report();
  report.valueWords = span.size() - nodeWords;
  std::vector<Stream> streams = {wordStream(span)};
  if (isStreamed_)
    if (auto finished = writer_->finish(info_, streams, words.settled(), *options_.memory); !finished)
      return finished.error();
  Volume volume(std::move(info_), std::move(streams), std::make_shared<const MemoryBlock>(words.take()));
  if (!options_.path.empty() && !isStreamed_)
    if (auto saved = volume.save(options_.path); !saved)
      return saved.error();
  report.writeSeconds = writing.seconds();
  report.seconds = watch_.seconds();
  report.cpuSeconds = watch_.cpuSeconds();
  report.scratchBytes = options_.memory->scratchPeak();
  return Built{std::move(volume), std::move(report)};
}

} // namespace voxc
