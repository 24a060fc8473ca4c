// Parts of a volume, one after the other in Morton order, and their joining to the whole.
#pragma once

#include "BuildHost.h"
#include "ColourFact.h"
#include "Fragment.h"
#include "SourceHost.h"
#include "ValueStore.h"

#include <optional>

namespace voxc {

/// Where built parts come from.
class PartStream {
public:
  virtual ~PartStream() = default;

  /// The corner of the next part that holds anything, or nothing at the end; waits until it is known.
  virtual std::optional<Int3> next() = 0;
  /// That part; may be called once for each `next`. Errors end the work.
  virtual Expected<Fragment> take() = 0;
};

/// The host of the last step: cubes of the size of a part come from a stream, what is above them from the
/// generated code.
class MergeHost final : public BuildHost {
public:
  MergeHost(PartStream &parts, int log2Part, const Layout &layout, Int3 extent, NodeStore &store,
            ValueStore &values, const Progress &progress)
      : BuildHost(store), parts_(parts), log2Part_(log2Part), layout_(layout), splice_(layout, store),
        values_(values), colours_(layout.voxelFacts()), progress_(extent, progress) {}

  std::uint64_t voxels() const { return voxels_; }
  /// The one colour of all voxels, of `Payload::Constant`.
  std::uint32_t colour() const { return colours_.one(); }

protected:
  bool isEmpty(const Cube &cube) override;
  void readBrick(Int3, std::uint32_t *) override;
  int log2Part() const override { return log2Part_; }
  construct::Part takePart(Int3 low) override;
  void putValue(std::uint32_t value) override { values_.put({&value, 1}); }

private:
  void proveColours(Int3 low);

  PartStream &parts_;
  int log2Part_;
  const Layout &layout_;
  Splice splice_;
  ValueStore &values_;
  ColourFact colours_;
  MortonProgress progress_;
  Fragment fragment_; ///< The last one: its cells are in use until the next is taken.
  std::uint64_t voxels_ = 0;
};

} // namespace voxc
