// One volume being built: where its words go, and what is reported when they are complete.
#pragma once

#include "Construct/Host/BuildHost.h"
#include "Construct/Nodes/NodeStore.h"
#include "Construct/Nodes/ValueStore.h"

#include "Volume/PagedFileWriter.h"
#include "Volume/VolumeFileWriter.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Support/Stopwatch.h"

#include <memory>
#include <optional>

namespace voxc {

/// Where the words of a volume come from.
enum class Origin {
  Built,   ///< Made here, of voxels.
  Foreign, ///< Read from files, which may be broken in ways that only the whole shows.
};

/// From the first word to the finished volume.
class VolumeBuild {
public:
  /// `info`: of the volume, but for the number of voxels. `layout` and `options` outlive this;
  /// `options.memory` is set. `emptyWords` are left before the first node. Errors: nothing can be written to
  /// the path; no memory.
  static Expected<std::unique_ptr<VolumeBuild>>
  start(VolumeInfo info, const Layout &layout, const BuildOptions &options, std::uint64_t emptyWords = 0);

  NodeStore &store() { return *store_; }
  ValueStore &values() { return *values_; }
  /// How many words there are, or were when the volume took them.
  std::uint64_t wordsReached() const { return wordsReached_ ? wordsReached_ : store_->words().size(); }

  /// Completes the volume. `root`: the offset of the root sub-volume. `colour`: that of all voxels, of
  /// a payload of one. `origin`: whether the words are proved before a file gets its name. Errors: the
  /// store's; a full disk; of foreign words that they are no volume, or of another number of voxels.
  Expected<Built> finish(std::uint32_t root, std::uint64_t voxels, std::uint32_t colour,
                         Origin origin = Origin::Built);

private:
  VolumeBuild(VolumeInfo info, const Layout &layout, const BuildOptions &options)
      : info_(std::move(info)), layout_(layout), options_(options) {}
  Expected<void> openFile();
  Expected<WordStore> openWords();
  void appendArray(WordStore &words);
  bool hasArrayForm() const;
  void appendArrayForm(WordStore &words, std::span<const std::uint32_t> blocks);
  void appendValues();
  /// Proves the words as the loader will.
  Expected<void> proveWords(std::span<const std::uint32_t> words) const;
  /// Writes the file, unless the words went to their place in it while they were made.
  Expected<void> save(const Volume &volume);

  Stopwatch watch_;
  VolumeInfo info_;
  const Layout &layout_;
  const BuildOptions &options_;
  std::optional<VolumeFileWriter> streamWriter_;
  std::optional<PagedFileWriter> pagedWriter_;
  std::unique_ptr<NodeStore> store_;
  std::unique_ptr<ValueStore> values_;
  std::uint64_t maxWords_ = 0;
  std::uint64_t wordsReached_ = 0; ///< Once the volume has taken them; before that the store knows.
};

} // namespace voxc
