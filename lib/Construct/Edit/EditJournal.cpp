// Adding to a journal, and what it makes of a volume.
#include "voxc/Construct/EditJournal.h"

#include "JournalFormat.h"

#include "Construct/Host/VoxelProof.h"
#include "Support/Platform/File.h"
#include "Support/Platform/Path.h"
#include "voxc/Construct/EditableVolume.h"
#include "voxc/Layout/Edits.h"
#include "voxc/Support/File.h"
#include "voxc/Support/WorkingMemory.h"
#include "voxc/Volume/Frames.h"
#include "voxc/Volume/VolumeSummary.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace voxc {
namespace {

Error cannotWrite(const std::string &path) {
  return Error::environment("cannot write '" + path + "': " + std::strerror(errno));
}

/// The journal of a volume file; one of another file is an error, unless its edits are in this one already.
Expected<journal::Contents> contentsFor(const std::string &volumePath, std::span<const std::byte> file) {
  const std::string path = journalPathOf(volumePath);
  auto contents = journal::parse(file, path);
  if (!contents || contents->records.empty()) // One without edits is none, of whatever file it was begun for.
    return contents ? Expected<journal::Contents>(journal::Contents{}) : contents;
  const auto identity = VOXC_TRY(journal::identityOf(volumePath));
  if (contents->identity == identity)
    return contents;
  const auto isOfThis = [&](const journal::Record &record) {
    return record.kind == journal::RecordKind::Closed && record.bytes.size() == sizeof identity &&
           std::memcmp(record.bytes.data(), identity.data(), sizeof identity) == 0;
  };
  if (!contents->records.empty() && isOfThis(contents->records.back()))
    return journal::Contents{};
  return Error::input("the journal '" + path + "' is of another file than '" + volumePath +
                      "', which was written since; put that file back, or remove the journal");
}

/// All of a descriptor, from its beginning.
Expected<std::string> readAll(int file, const std::string &path) {
  std::string text;
  char piece[1 << 16];
  for (ssize_t count = 0;
       (count = ::pread(file, piece, sizeof piece, static_cast<off_t>(text.size()))) != 0;) {
    if (count < 0)
      return Error::environment("cannot read '" + path + "': " + std::strerror(errno));
    text.append(piece, static_cast<std::size_t>(count));
  }
  return text;
}

/// True if a descriptor's file still has this name: a journal whose edits were put into the file loses it.
bool hasName(int file, const std::string &path) {
  struct stat own{}, named{};
  return ::fstat(file, &own) == 0 && ::stat(path.c_str(), &named) == 0 && own.st_ino == named.st_ino &&
         own.st_dev == named.st_dev;
}

/// Gives a file the permissions of another. False with `errno` if that fails.
bool takeAccess(const std::string &path, const std::string &other) {
  const int file = platform::openToRead(path);
  const bool taken = file >= 0 && platform::takeAccessOf(other, file);
  const int reason = errno;
  if (file >= 0)
    platform::close(file);
  errno = reason;
  return taken;
}

/// Whoever may read a volume, and no one else, may read its journal, which has voxels of it. Its owner goes
/// on writing to it, though the volume may be for reading alone.
bool giveAccess(int journal, const std::string &volumePath) {
  struct stat status{};
  return platform::takeAccessOf(volumePath, journal) && ::fstat(journal, &status) == 0 &&
         ((status.st_mode & S_IWUSR) != 0 || ::fchmod(journal, (status.st_mode & 0777) | S_IWUSR) == 0);
}

/// Sees onto the disk that a folder has a file.
void syncFolderOf(const std::string &path) {
  const int folder = ::open(platform::folderOf(path).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0)
    return;
  ::fsync(folder);
  ::close(folder);
}

/// Edits in place, where the format allows it; else a build of what they make of the volume.
Expected<Volume> edited(Volume volume, const std::vector<VoxelEdit> &edits, const LoadOptions &options,
                        const CompileCache *cache) {
  if (!whyNoEdits(volume.layout()).empty()) {
    auto constructor = VOXC_TRY(Constructor::compile(volume.format(), cache));
    BuildOptions building;
    building.memory = options.memory;
    building.progress = options.progress;
    building.provenance = volume.info().provenance;
    auto built = constructor.edit(std::make_shared<const Volume>(std::move(volume)), edits, building);
    return built ? Expected<Volume>(std::move(built->volume)) : built.error();
  }
  auto editable = VOXC_TRY(
      EditableVolume::create(volume, {.memory = options.memory, .cache = cache, .shareWithFirst = false}));
  for (const VoxelEdit &edit : edits)
    VOXC_TRY(editable.apply(*makeChange(edit)));
  return editable.view(editable.snapshot());
}

/// A volume file with the edits of its journal, and those that would be the next.
Expected<Volume> loadWith(const std::string &path, const std::vector<VoxelEdit> &next,
                          const LoadOptions &options, const CompileCache *cache) {
  auto [volume, edits] = VOXC_TRY(loadWaiting(path, options));
  if (auto checked = checkEdits(edits, volume.info().extent); !checked)
    return Error::input("'" + journalPathOf(path) + "' is broken: " + checked.error().message);
  edits.insert(edits.end(), next.begin(), next.end());
  return edits.empty() ? std::move(volume) : edited(std::move(volume), edits, options, cache);
}

} // namespace

/// One without edits goes while it is locked: who has opened it meanwhile finds that it has no name.
EditJournal::~EditJournal() {
  if (file_ < 0)
    return;
  if (isEmpty_ && hasName(file_, path_))
    platform::removeFile(path_);
  ::close(file_);
}

EditJournal::EditJournal(EditJournal &&other) noexcept
    : volumePath_(std::move(other.volumePath_)), path_(std::move(other.path_)),
      file_(std::exchange(other.file_, -1)), isEmpty_(other.isEmpty_), info_(std::move(other.info_)),
      transactions_(other.transactions_) {}

Expected<EditJournal> EditJournal::open(const std::string &volumePath) {
  auto summary = summarizeVolume(volumePath);
  if (summary &&
      std::ranges::find(summary->streams, kFrameStream, &StreamSummary::name) != summary->streams.end())
    return Error::input("'" + volumePath +
                        "' has frames, which a journal cannot tell apart; --frame N with -o edits one of "
                        "them, and writes that one alone");
  if (!summary)
    return summary.error();
  const std::string path = journalPathOf(volumePath);
  EditJournal journal(volumePath, path, ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  if (journal.file_ < 0)
    return cannotWrite(path);
  if (::flock(journal.file_, LOCK_EX | LOCK_NB) != 0)
    return Error::environment("another process writes '" + path + "'; try again when it has ended");
  if (!hasName(journal.file_, path))
    return open(volumePath);
  // Until it was locked another process may have put its edits into the file.
  const auto identity = VOXC_TRY(journal::identityOf(volumePath));
  summary = summarizeVolume(volumePath);
  if (!summary)
    return summary.error();
  auto text = VOXC_TRY(readAll(journal.file_, path));
  const auto contents = VOXC_TRY(contentsFor(volumePath, std::as_bytes(std::span(text.data(), text.size()))));
  journal.info_ = std::move(summary->info);
  journal.transactions_ = contents.records.size();
  if (::ftruncate(journal.file_, static_cast<off_t>(contents.end)) != 0)
    return cannotWrite(path);
  if (contents.end > 0)
    return journal;
  journal.isEmpty_ = true;
  if (!giveAccess(journal.file_, volumePath))
    return cannotWrite(path);
  journal::Head head = journal::kHead;
  head.identity = identity;
  VOXC_TRY(journal.write(std::string(reinterpret_cast<const char *>(&head), sizeof head)));
  syncFolderOf(path);
  return journal;
}

/// Adds bytes at the end and sees them onto the disk.
Expected<void> EditJournal::write(const std::string &record) {
  const off_t end = ::lseek(file_, 0, SEEK_END);
  const auto bytes = std::as_bytes(std::span(record.data(), record.size()));
  if (platform::writeAt(file_, bytes, static_cast<std::uint64_t>(end)) && platform::writeThrough(file_))
    return {};
  Error failure = cannotWrite(path_);
  // Readers stop at a record that is not whole: no other may come behind it.
  if (::ftruncate(file_, end) != 0)
    ::close(std::exchange(file_, -1));
  return failure;
}

/// Makes the volume as a reader of the journal will: a word that the format cannot keep would keep it from
/// the volume, whatever edits came later.
Expected<void> EditJournal::prove(const std::vector<VoxelEdit> &edits, const LoadOptions &options,
                                  const CompileCache *cache) const {
  if (!VoxelProof(layoutOf(info_.format).voxelFacts()).isNeeded())
    return {};
  const auto made = loadWith(volumePath_, edits, options, cache);
  return made ? Expected<void>() : made.error();
}

Expected<void> EditJournal::append(const std::vector<VoxelEdit> &edits, const LoadOptions &options,
                                   const CompileCache *cache) {
  VOXC_TRY(checkEdits(edits, info_.extent));
  VOXC_TRY(prove(edits, options, cache));
  const auto bytes = VOXC_TRY(journal::editsText(edits));
  VOXC_TRY(write(journal::recordText(journal::RecordKind::Edits, transactions_, bytes)));
  ++transactions_;
  isEmpty_ = false;
  return {};
}

/// Says that a file has all edits, which is about to take the name of the volume: where the journal is then
/// found beside it, it counts for nothing.
Expected<void> EditJournal::close(const std::string &compacted) {
  const auto identity = VOXC_TRY(journal::identityOf(compacted));
  const std::string bytes(reinterpret_cast<const char *>(identity.data()), sizeof identity);
  return write(journal::recordText(journal::RecordKind::Closed, transactions_, bytes));
}

Expected<void> EditJournal::fold(const std::string &compacted) {
  const auto end = platform::followLinks(volumePath_);
  Expected<void> folded =
      end && takeAccess(compacted, end->path) ? close(compacted) : cannotWrite(volumePath_);
  if (folded && !platform::renameOver(compacted, end->path))
    folded = cannotWrite(volumePath_);
  platform::removeFile(folded ? path_ : compacted);
  return folded;
}

Expected<std::vector<VoxelEdit>> readJournal(const std::string &volumePath,
                                             std::shared_ptr<WorkingMemory> memory) {
  std::vector<VoxelEdit> edits;
  const std::string path = journalPathOf(volumePath);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    return edits;
  auto file = VOXC_TRY(MappedFile::open(path));
  const auto contents = VOXC_TRY(contentsFor(volumePath, file.bytes()));
  if (!memory)
    memory = WorkingMemory::createDefault();
  for (const journal::Record &record : contents.records)
    if (record.kind == journal::RecordKind::Edits)
      if (auto parsed = journal::parseEdits(record.bytes, memory, edits); !parsed)
        return Error::input("'" + path + "' is broken: " + parsed.error().message);
  return edits;
}

Expected<WaitingVolume> loadWaiting(const std::string &path, const LoadOptions &options) {
  LoadOptions loading = options;
  loading.withoutJournal = true;
  for (;;) {
    const auto before = journal::identityOf(path);
    auto volume = VOXC_TRY(Volume::load(path, loading));
    auto edits = readJournal(path, options.memory);
    // Edits that another process has put into the file meanwhile are in neither.
    const auto now = journal::identityOf(path);
    if (before && now && *before != *now)
      continue;
    if (!edits)
      return edits.error();
    return WaitingVolume{std::move(volume), std::move(*edits)};
  }
}

Expected<Volume> loadEdited(const std::string &path, const LoadOptions &options, const CompileCache *cache) {
  return loadWith(path, {}, options, cache);
}

} // namespace voxc
