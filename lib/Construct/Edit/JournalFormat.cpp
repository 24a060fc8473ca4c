// Journals as bytes.
#include "JournalFormat.h"

#include "Support/Platform/ScratchFile.h"
#include "Volume/Checksum.h"
#include "voxc/Support/File.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <sys/mman.h>
#include <unistd.h>

namespace voxc::journal {
namespace {

/// Where the head of a volume file has its checksum, and its size behind it (docs/hvx.md).
constexpr std::size_t kIdentityAt = 16;

/// How often bytes are looked at, of which each may begin a record.
constexpr std::uint64_t kMostLooks = 64;

/// An edit, whose pasted volume follows as a .hvx file of so many bytes; 0: none.
struct EditHead {
  std::int32_t low[3];
  std::int32_t size[3];
  std::uint32_t word;
  std::uint32_t unused;
  std::uint64_t pastedBytes;
};

template <typename T> void add(std::string &bytes, const T &value) {
  bytes.append(reinterpret_cast<const char *>(&value), sizeof value);
}

/// Takes a value off the front of bytes. False if they are too few.
template <typename T> bool take(std::span<const std::byte> &bytes, T &value) {
  if (bytes.size() < sizeof value)
    return false;
  std::memcpy(&value, bytes.data(), sizeof value);
  bytes = bytes.subspan(sizeof value);
  return true;
}

std::uint64_t checksumOf(RecordKind kind, std::uint64_t number, std::span<const std::byte> bytes) {
  Checksum checksum;
  checksum.add(&kind, sizeof kind);
  checksum.add(&number, sizeof number);
  checksum.add(bytes.data(), bytes.size());
  return checksum.digest();
}

/// A file in memory, for what is written and read by path alone.
class MemoryFile {
public:
  MemoryFile() : file_(::memfd_create("voxc", MFD_CLOEXEC)) {}
  ~MemoryFile() {
    if (file_ >= 0)
      ::close(file_);
  }
  MemoryFile(const MemoryFile &) = delete;
  MemoryFile &operator=(const MemoryFile &) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(file_); }
  bool write(std::span<const std::byte> bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(file_, bytes.data(), bytes.size());
      if (written <= 0)
        return false;
      bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
  }

private:
  int file_;
};

/// The bytes of a compressed .hvx file.
Expected<std::string> fileOf(const Volume &volume) {
  std::string path = platform::scratchFolder() + "/voxc-paste.XXXXXX";
  const int file = ::mkstemp(path.data());
  if (file < 0)
    return Error::environment("cannot write '" + path + "': " + std::strerror(errno));
  ::close(file);
  auto saved = volume.save(path, {.compress = true});
  auto text = saved ? readTextFile(path) : Expected<std::string>(saved.error());
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  return text;
}

Expected<std::shared_ptr<const Volume>> volumeOf(std::span<const std::byte> file,
                                                 const std::shared_ptr<WorkingMemory> &working) {
  const MemoryFile memory;
  if (!memory.write(file))
    return Error::environment("there is no memory for a volume that was pasted");
  auto volume = VOXC_TRY(Volume::load(memory.path(), {.memory = working, .withoutJournal = true}));
  return std::make_shared<const Volume>(std::move(volume));
}

/// The record of this number with which `rest` begins, taken from there; none if it is not whole.
std::optional<Record> takeRecord(std::span<const std::byte> &rest, std::uint64_t number) {
  RecordHead head{};
  std::span<const std::byte> behind = rest;
  if (!take(behind, head) || head.bytes > behind.size())
    return std::nullopt;
  const auto bytes = behind.first(static_cast<std::size_t>(head.bytes));
  if (head.checksum != checksumOf(head.kind, number, bytes))
    return std::nullopt;
  rest = behind.subspan(bytes.size());
  return Record{head.kind, bytes};
}

bool isOfRecord(const RecordHead &head) {
  return (head.kind == RecordKind::Edits || head.kind == RecordKind::Closed) && head.unused == 0;
}

/// Whether the record of this number, with which `rest` begins and which is not whole, was whole once: each
/// is on the disk before the next is begun, and so nothing stands behind one that is not. Its length may be
/// what is damaged, so that the next may begin anywhere.
bool isDamaged(std::span<const std::byte> rest, std::uint64_t number) {
  RecordHead head{};
  std::span<const std::byte> behind = rest;
  if (take(behind, head) && isOfRecord(head) && head.bytes < behind.size())
    return true;
  std::uint64_t looks = kMostLooks * rest.size();
  for (std::size_t at = 1; at < rest.size(); ++at) {
    behind = rest.subspan(at);
    if (!take(behind, head) || !isOfRecord(head) || head.bytes > behind.size())
      continue;
    behind = rest.subspan(at);
    if (head.bytes > looks || takeRecord(behind, number + 1))
      return true;
    looks -= head.bytes;
  }
  return false;
}

} // namespace

std::string recordText(RecordKind kind, std::uint64_t number, const std::string &bytes) {
  std::string text;
  add(text, RecordHead{kind, 0, bytes.size(),
                       checksumOf(kind, number, std::as_bytes(std::span(bytes.data(), bytes.size())))});
  return text + bytes;
}

Expected<Contents> parse(std::span<const std::byte> file, const std::string &path) {
  Contents contents;
  Head head = kHead;
  std::span<const std::byte> rest = file;
  if (!take(rest, head)) // It was being begun.
    return contents;
  contents.identity = std::exchange(head.identity, {});
  if (std::memcmp(&head, &kHead, sizeof head) != 0)
    return Error::input("'" + path + "' is no journal of edits");
  while (const auto record = takeRecord(rest, contents.records.size()))
    contents.records.push_back(*record);
  contents.end = file.size() - rest.size();
  if (isDamaged(rest, contents.records.size()))
    return Error::input("the journal '" + path + "' is damaged at its edit " +
                        std::to_string(contents.records.size() + 1) +
                        ", behind which there are others; put back a copy of it, or remove it");
  return contents;
}

Expected<Identity> identityOf(const std::string &volumePath) {
  auto file = VOXC_TRY(MappedFile::open(volumePath));
  Identity identity{};
  auto bytes = file.bytes();
  if (bytes.size() < kIdentityAt + sizeof identity)
    return Error::input("'" + volumePath + "' is not a .hvx volume");
  std::memcpy(&identity, bytes.data() + kIdentityAt, sizeof identity);
  return identity;
}

Expected<std::string> editsText(const std::vector<VoxelEdit> &edits) {
  std::string bytes;
  for (const VoxelEdit &edit : edits) {
    auto pasted = VOXC_TRY(edit.pasted ? fileOf(*edit.pasted) : Expected<std::string>(std::string()));
    add(bytes, EditHead{{edit.low.x, edit.low.y, edit.low.z},
                        {edit.size.x, edit.size.y, edit.size.z},
                        edit.word,
                        0,
                        pasted.size()});
    bytes += pasted;
  }
  return bytes;
}

Expected<void> parseEdits(std::span<const std::byte> bytes, const std::shared_ptr<WorkingMemory> &memory,
                          std::vector<VoxelEdit> &edits) {
  EditHead head{};
  while (take(bytes, head)) {
    if (head.pastedBytes > bytes.size())
      return Error::input("a journal of edits has a volume that is cut short");
    VoxelEdit edit{
        {head.low[0], head.low[1], head.low[2]}, {head.size[0], head.size[1], head.size[2]}, head.word, {}};
    if (head.pastedBytes > 0) {
      edit.pasted = VOXC_TRY(volumeOf(bytes.first(static_cast<std::size_t>(head.pastedBytes)), memory));
      edit.size = edit.pasted->info().extent;
      bytes = bytes.subspan(static_cast<std::size_t>(head.pastedBytes));
    }
    edits.push_back(std::move(edit));
  }
  return bytes.empty() ? Expected<void>() : Error::input("a journal of edits has an edit that is cut short");
}

} // namespace voxc::journal
