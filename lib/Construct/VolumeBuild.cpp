// Opening and completing a volume.
#include "VolumeBuild.h"

#include "Volume/Structure.h"
#include "voxc/Layout/SlotKind.h"

#include <algorithm>
#include <vector>

namespace voxc {
namespace {

constexpr std::size_t kWordsAtATime = 4096;
/// What a proof touches between two looks: shared nodes lie anywhere, each in a page of its own.
constexpr std::uint64_t kBytesOfLooks = std::uint64_t{16} << 20;

} // namespace

Expected<std::unique_ptr<VolumeBuild>> VolumeBuild::start(VolumeInfo info, const Layout &layout,
                                                          const BuildOptions &options,
                                                          std::uint64_t emptyWords) {
  std::unique_ptr<VolumeBuild> build(new VolumeBuild(std::move(info), layout, options));
  // Counted at the end; their record has its room in the head from the beginning.
  build->info_.wordCounts = WordCounts{std::vector<std::uint64_t>(layout.strata.size()), 0};
  build->maxWords_ = std::min(options.maxWords, layout.maxWords());
  auto words = VOXC_TRY(build->openWords());
  const std::vector<std::uint32_t> head(layout.headWords() - words.size());
  VOXC_TRY(words.append(head));
  VOXC_TRY(words.skip(emptyWords));
  build->store_ = std::make_unique<NodeStore>(std::move(words), layout, options.memory);
  build->values_ = std::make_unique<ValueStore>(*build->store_, layout.voxelFacts(), options.memory);
  build->store_->limit(build->maxWords_);
  build->store_->countReferences();
  return build;
}

Expected<void> VolumeBuild::openFile() {
  if (options_.path.empty())
    return {};
  if (options_.compress) {
    auto writer = VOXC_TRY(PagedFileWriter::create(options_.path));
    pagedWriter_.emplace(std::move(writer));
  }
  const bool isRegular = VOXC_TRY(OutputFile::isRegularAt(options_.path));
  if (!isRegular)
    return {}; // It takes the words once they are complete, and is opened then, once.
  // Compressed, the words lie there until they are complete; no name is given to this file then.
  auto writer = VOXC_TRY(VolumeFileWriter::create(options_.path, info_));
  streamWriter_.emplace(std::move(writer));
  return {};
}

Expected<WordStore> VolumeBuild::openWords() {
  VOXC_TRY(openFile());
  if (!streamWriter_)
    return WordStore::create(options_.memory, {}, maxWords_);
  const auto flush = [this](MemoryBlock &block, std::uint64_t begin, std::uint64_t bytes) {
    return streamWriter_->flush(block, begin, bytes, *options_.memory);
  };
  return WordStore::create(options_.memory, flush, maxWords_);
}

/// The array of indexed sub-volumes stands behind all nodes. Its number 0, the empty one, is not written
/// alone: a volume without voxels is its head.
void VolumeBuild::appendArray(WordStore &words) {
  const auto array = store_->array();
  if (array.size() <= kIndexedWords || store_->failure())
    return;
  if (words.size() + array.size() > maxWords_)
    return store_->fail(Error::input("the volume needs more than " + std::to_string(maxWords_) +
                                     " words, the most that it may have"));
  words.setHead(layout_.headWords() - 1, static_cast<std::uint32_t>(words.size()));
  if (hasArrayForm())
    return appendArrayForm(words, array);
  if (auto appended = words.append(array); !appended)
    store_->fail(appended.error());
}

/// True if the array is written otherwise than as the blocks that were collected.
bool VolumeBuild::hasArrayForm() const {
  const Stratum &last = layout_.strata.back();
  return last.inArray() && last.slots->array->write;
}

void VolumeBuild::appendArrayForm(WordStore &words, std::span<const std::uint32_t> blocks) {
  std::vector<std::uint32_t> some;
  const auto flush = [&] {
    if (auto appended = words.append(some); !appended)
      store_->fail(appended.error());
    some.clear();
  };
  layout_.strata.back().slots->array->write(blocks, [&](std::uint32_t word) {
    some.push_back(word);
    if (some.size() == kWordsAtATime)
      flush();
  });
  flush();
}

/// The values of voxels stand behind all nodes too, where a reference can lead to.
void VolumeBuild::appendValues() {
  store_->align();
  WordStore &words = store_->words();
  const std::uint64_t section = words.size();
  values_->finish(words, maxWords_);
  words.setHead(1, layout_.refOf(section));
  if (words.size() - section > layout_.maxNodeWords())
    store_->fail(Error::input("the values of the voxels take " + std::to_string(words.size() - section) +
                              " words, more than the 2^32 - 2^28 that a kernel can reach where references "
                              "count granules; a lower resolution would fit"));
}

Expected<void> VolumeBuild::proveWords(std::span<const std::uint32_t> words) const {
  options_.progress.at("check", 0);
  const auto keepOn = [this] {
    options_.memory->relieve(kBytesOfLooks);
    return !options_.progress.stopped();
  };
  const auto voxels = checkStructure(layout_, words, keepOn);
  if (!voxels && voxels.error().kind != ErrorKind::Interrupted)
    return Error::input("the parts do not make a volume: " + voxels.error().message);
  if (!voxels)
    return voxels.error();
  if (*voxels != info_.voxels)
    return Error::input("the parts do not make a volume: they hold " + std::to_string(*voxels) +
                        " voxels, but say that there are " + std::to_string(info_.voxels));
  return {};
}

Expected<void> VolumeBuild::save(const Volume &volume) {
  const SaveOptions saving{.compress = options_.compress,
                           .threads = options_.threads,
                           .memory = options_.memory,
                           .progress = options_.progress};
  if (pagedWriter_)
    return pagedWriter_->finish(volume.info(), volume.streams(), saving);
  return options_.path.empty() || streamWriter_ ? Expected<void>() : volume.save(options_.path);
}

namespace {

WordCounts countsOf(const BuildReport &report) {
  WordCounts counts{{}, report.valueWords};
  for (const LevelReport &level : report.levels)
    counts.levels.push_back(level.words);
  return counts;
}

} // namespace

Expected<Built> VolumeBuild::finish(std::uint32_t root, std::uint64_t voxels, std::uint32_t colour,
                                    Origin origin) {
  WordStore &words = store_->words();
  const std::uint64_t arrayBegin = words.size();
  appendArray(words);
  const std::uint64_t nodeWords = words.size();
  if (layout_.ranksVoxels())
    appendValues();
  if (layout_.hasOneColour())
    words.setHead(1, colour);
  if (store_->failure())
    return *store_->failure();
  words.setRoot(root);
  store_->forgetAll();
  info_.voxels = voxels;
  const auto span = words.span();
  if (origin == Origin::Foreign)
    VOXC_TRY(proveWords(span));
  options_.progress.at("write", 0);
  const Stopwatch writing;
  wordsReached_ = span.size();
  BuildReport report;
  report.voxels = voxels;
  report.levels = store_->report();
  if (hasArrayForm())
    report.levels.back().words = nodeWords - arrayBegin;
  report.valueWords = span.size() - nodeWords;
  info_.wordCounts = countsOf(report);
  std::vector<Stream> streams = {wordStream(span)};
  if (streamWriter_ && !pagedWriter_)
    VOXC_TRY(streamWriter_->finish(info_, streams, words.flushed(), *options_.memory));
  Volume volume(std::move(info_), std::move(streams), std::make_shared<const MemoryBlock>(words.take()));
  VOXC_TRY(save(volume));
  report.writeSeconds = writing.seconds();
  report.seconds = watch_.seconds();
  report.cpuSeconds = watch_.cpuSeconds();
  report.scratchBytes = options_.memory->scratchPeak();
  return Built{std::move(volume), std::move(report)};
}

} // namespace voxc
