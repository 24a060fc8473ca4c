// Parts of a volume, one after the other in Morton order, and their joining to the whole.
#pragma once

#include "Construct/Host/BuildHost.h"
#include "Construct/Host/ColourFact.h"
#include "Construct/Host/SourceHost.h"
#include "Fragment.h"

#include "voxc/Support/Next.h"

#include <optional>
#include <span>

namespace voxc {

/// Where built parts come from.
class PartStream {
public:
  virtual ~PartStream() = default;

  /// The cube of the next part that holds anything; waits until it is known. The end comes only when all that
  /// the stream has to give was looked at. Errors: why the stream stopped before.
  virtual Next<Cube> next() = 0;
  /// That part; may be called once for each `next` that gave a cube. Errors end the work.
  virtual Expected<Fragment> take() = 0;
};

/// The host of the last step: cubes that are parts come from a stream, what is above them from the generated
/// code.
class MergeHost : public BuildHost {
public:
  /// The layout outlives the host.
  MergeHost(PartStream &parts, const Layout &layout, Int3 extent, NodeStore &store, const Progress &progress)
      : BuildHost(store), parts_(parts), layout_(layout), splice_(layout, store),
        colours_(layout.voxelFacts()), progress_(extent, progress) {
    if (const auto first = lookAhead())
      setPartSide(first->log2Side);
  }

  std::uint64_t voxels() const { return voxels_; }
  /// The one colour of all voxels (`Layout::hasOneColour`).
  std::uint32_t colour() const { return colours_.one(); }

protected:
  bool isEmpty(const Cube &cube) override;
  void readBrick(Int3, construct::Brick &brick) override;
  construct::Part takePart(Int3 low) override;
  void putValue(std::uint32_t value) final { putValues({&value, 1}); }
  /// The values of the next voxels, of a layout with values apart.
  virtual void putValues(std::span<const std::uint32_t> values) = 0;

private:
  /// The cube of the next part; none at the end or after a failure, which the store then has.
  std::optional<Cube> lookAhead();
  void proveColours(Int3 low);

  PartStream &parts_;
  const Layout &layout_;
  Splice splice_;
  ColourFact colours_;
  MortonProgress progress_;
  Fragment fragment_; ///< The last one: its cells are in use until the next is taken.
  std::uint64_t voxels_ = 0;
};

} // namespace voxc
