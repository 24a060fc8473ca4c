// Fuzzes files of fragments and what joins them: the checksum is put right, as a hostile file's would be.
#include "FuzzedFile.h"
#include "WordMutator.h"

#include "Construct/Fragments/FragmentSet.h"
#include "Construct/Nodes/WordStore.h"
#include "Volume/Checksum.h"

#include <cstring>

namespace {

using namespace voxc;

constexpr std::size_t kHeaderBytes = 200;
constexpr std::size_t kChecksumAt = 16;

std::string withChecksum(std::string bytes) {
  if (bytes.size() < kHeaderBytes)
    return bytes;
  std::memset(bytes.data() + kChecksumAt, 0, sizeof(std::uint64_t));
  Checksum checksum;
  checksum.add(bytes.data() + kHeaderBytes, bytes.size() - kHeaderBytes);
  checksum.add(bytes.data(), kHeaderBytes);
  const std::uint64_t digest = checksum.digest();
  std::memcpy(bytes.data() + kChecksumAt, &digest, sizeof digest);
  return bytes;
}

/// Joins all parts to words; what generated code would put above them needs no file.
void join(FragmentSet &fragments, const std::shared_ptr<WorkingMemory> &memory) {
  const Format &format = fragments.info().volume.format;
  auto words = WordStore::create(memory);
  if (!words)
    return;
  const Layout layout = layoutOf(format);
  NodeStore store(std::move(*words), layout, memory);
  Splice splice(layout, store);
  for (auto next = fragments.next(); !next.isEnd() && !next.failed() && !store.failure();
       next = fragments.next()) {
    auto fragment = fragments.take();
    if (!fragment)
      return;
    splice.join(*fragment);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char *data, std::size_t size) {
  const std::string path = fuzz::folder().write("a.hvf", withChecksum(std::string(fuzz::textOf(data, size))));
  const auto memory = WorkingMemory::create(std::uint64_t{64} << 20);
  if (auto fragments = FragmentSet::open({path}, memory))
    join(*fragments, memory);
  return 0;
}
