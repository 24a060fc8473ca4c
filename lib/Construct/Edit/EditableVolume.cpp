// A store, the code that edits it, and the states that it has been in.
#include "voxc/Construct/EditableVolume.h"

#include "Adoption.h"
#include "EditCode.h"

#include "voxc/Source/Sources.h"
#include "voxc/Support/Stopwatch.h"
#include "voxc/Volume/Frames.h"

#include <optional>

namespace voxc {

struct EditableVolume::State {
  VolumeInfo info;
  Layout layout;
  std::shared_ptr<WorkingMemory> memory;
  EditCode code;
  double compileSeconds = 0;
  const CompileCache *cache = nullptr;
  std::shared_ptr<EditStore> store; ///< Which volumes of the words keep.
  std::unique_ptr<EditHost> host;
  std::uint64_t firstWords = 0;
  std::vector<Snapshot> frames;           ///< Of the first volume.
  std::shared_ptr<const Volume> volume;   ///< As it is now, once it was asked for.
  std::optional<Constructor> constructor; ///< Once there was a compaction.

  Volume asVolume(std::span<const std::uint32_t> words, std::uint64_t voxels,
                  std::shared_ptr<const void> owner) const {
    VolumeInfo own = info;
    own.voxels = voxels;
    own.wordCounts.reset(); // Words that no state has are of no level.
    // A volume without voxels has no words but those of its head.
    return {std::move(own), words[0] == 0 ? words.first(layout.headWords()) : words, std::move(owner)};
  }
};

EditableVolume::EditableVolume(std::unique_ptr<State> state) : state_(std::move(state)) {}
EditableVolume::~EditableVolume() = default;
EditableVolume::EditableVolume(EditableVolume &&) noexcept = default;
EditableVolume &EditableVolume::operator=(EditableVolume &&) noexcept = default;

Expected<EditableVolume> EditableVolume::create(const Volume &volume, const EditableOptions &options) {
  const Stopwatch watch;
  auto code = VOXC_TRY(EditCode::compile(volume.format(), options.cache));
  auto memory = options.memory ? options.memory : WorkingMemory::createDefault();
  std::unique_ptr<State> state(
      new State{.info = volume.info(), .layout = volume.layout(), .memory = memory, .code = std::move(code)});
  state->compileSeconds = watch.seconds();
  state->cache = options.cache;
  state->firstWords = volume.words().size();
  for (const Frame &frame : framesOf(volume))
    state->frames.push_back({frame.root, frame.voxels});
  state->store = VOXC_TRY(EditStore::create(volume.words(), state->layout, memory));
  if (!state->frames.empty())
    state->store->seal();
  state->host = std::make_unique<EditHost>(*state->store, state->layout, state->info.extent);
  state->code.begin(*state->host);
  if (options.shareWithFirst) {
    OldNodes nodes(state->layout);
    nodes.read(state->store->words());
    Adoption adoption(nodes, state->store->nodes(), state->firstWords);
    adoption.subVolume(1, state->store->root());
    for (const Snapshot &frame : state->frames)
      adoption.subVolume(1, frame.root);
    if (auto failure = state->store->nodes().takeFailure())
      return *failure;
  }
  return EditableVolume(std::move(state));
}

Expected<EditReport> EditableVolume::apply(VoxelChange &change) {
  EditStore &store = *state_->store;
  const std::uint64_t before = store.words().size();
  state_->host->begin(change);
  const Ref root = state_->code.edit(store.root());
  state_->volume.reset();
  if (auto failure = store.nodes().takeFailure()) {
    store.rollBack();
    state_->host->undo();
    state_->code.begin(*state_->host); // What it has found since the failure is nothing.
    return *failure;
  }
  store.commit(root);
  if (state_->layout.hasOneColour())
    store.setHead(root, state_->host->colour());
  const std::int64_t more = state_->host->moreVoxels();
  state_->info.voxels += static_cast<std::uint64_t>(more);
  return EditReport{more, store.words().size() - before};
}

EditableVolume::Snapshot EditableVolume::snapshot() {
  state_->store->seal();
  return {state_->store->root(), state_->info.voxels};
}

void EditableVolume::restore(const Snapshot &snapshot) {
  state_->store->setHead(snapshot.root, 0);
  state_->info.voxels = snapshot.voxels;
  state_->volume.reset();
}

std::shared_ptr<const Volume> EditableVolume::volume() {
  if (!state_->volume)
    state_->volume = std::make_shared<const Volume>(
        state_->asVolume(state_->store->words(), state_->info.voxels, state_->store));
  return state_->volume;
}

Expected<Volume> EditableVolume::view(const Snapshot &snapshot) {
  auto words = VOXC_TRY(state_->store->view(snapshot.root));
  const std::span<const std::uint32_t> span(reinterpret_cast<const std::uint32_t *>(words.data()),
                                            state_->store->words().size());
  return state_->asVolume(span, snapshot.voxels, std::make_shared<const MemoryBlock>(std::move(words)));
}

std::vector<EditableVolume::Snapshot> EditableVolume::frames() const { return state_->frames; }

Expected<Volume> EditableVolume::framed(const std::vector<Snapshot> &states) {
  struct Held {
    MemoryBlock words;
    std::vector<Frame> frames;
  };
  if (states.size() > kMostFrames)
    return Error::usage("an animation has at most " + std::to_string(kMostFrames) + " frames, not " +
                        std::to_string(states.size()));
  state_->store->seal();
  auto words = VOXC_TRY(state_->store->view(states.front().root));
  const auto held = std::make_shared<Held>(Held{std::move(words), {}});
  for (const Snapshot &state : states)
    held->frames.push_back({state.root, 0, state.voxels});
  const std::span<const std::uint32_t> span(reinterpret_cast<const std::uint32_t *>(held->words.data()),
                                            state_->store->words().size());
  VolumeInfo info = state_->info;
  info.voxels = states.front().voxels;
  info.wordCounts.reset();
  return Volume(std::move(info), {wordStream(span), frameStream(held->frames)}, held);
}

std::uint64_t EditableVolume::voxels() const { return state_->info.voxels; }
std::uint64_t EditableVolume::words() const { return state_->store->words().size(); }
std::vector<WordRange> EditableVolume::takeChanges() { return state_->store->takeChanges(); }
void EditableVolume::putBackChanges(std::span<const WordRange> changes) {
  state_->store->putBackChanges(changes);
}
double EditableVolume::compileSeconds() const { return state_->compileSeconds; }

bool EditableVolume::wantsCompaction() const { return words() > state_->firstWords + state_->firstWords / 2; }

BuildResult EditableVolume::compact(const BuildOptions &options) const {
  if (!state_->constructor) {
    auto constructor = VOXC_TRY(Constructor::compile(state_->info.format, state_->cache));
    state_->constructor.emplace(std::move(constructor));
  }
  const auto volume = std::make_shared<const Volume>(
      state_->asVolume(state_->store->words(), state_->info.voxels, state_->store));
  const auto source = makeVolumeSource(volume);
  return state_->constructor->build(*source, options);
}

} // namespace voxc
