// Running the generated code over finished parts, for a part.
#include "JoinedParts.h"

namespace voxc {
namespace {

/// The host of a part that is made of parts.
class JoinHost final : public MergeHost {
public:
  JoinHost(FragmentSet &stream, const Layout &layout, NodeStore &store, const Progress &progress,
           Fragment &fragment)
      : MergeHost(stream, layout, stream.info().volume.extent, store, progress), fragment_(fragment) {}

protected:
  void putValues(std::span<const std::uint32_t> values) override {
    fragment_.values.insert(fragment_.values.end(), values.begin(), values.end());
  }
  void finishNode(const construct::Node &node) override { fragment_.node = node; }
  void finishCell(const construct::PlacedCell &cell) override { fragment_.cells.push_back(cell); }

private:
  Fragment &fragment_;
};

} // namespace

Expected<JoinedParts> JoinedParts::create(FragmentSet &stream, const ConstructCode &code,
                                          const std::shared_ptr<WorkingMemory> &memory) {
  auto words = VOXC_TRY(WordStore::create(memory));
  auto layout = std::make_unique<Layout>(stream.layout().countingWords());
  auto store = std::make_unique<NodeStore>(std::move(words), *layout, memory);
  return JoinedParts(stream, code, std::move(layout), std::move(store));
}

Expected<Fragment> JoinedParts::join(const Cube &cube, const Progress &progress) {
  const auto next = stream_.next();
  if (next.failed())
    return next.error();
  if (!next.isEnd() && next->log2Side == cube.log2Side)
    return stream_.take();
  Fragment fragment;
  fragment.cube = cube;
  store_->clear();
  store_->logTo(&fragment.blocks);
  JoinHost host(stream_, *layout_, *store_, progress, fragment);
  VOXC_TRY(code_.part(host, cube));
  keepWords(*store_, fragment);
  fragment.voxels = host.voxels();
  fragment.colour = host.colour();
  return fragment;
}

} // namespace voxc
