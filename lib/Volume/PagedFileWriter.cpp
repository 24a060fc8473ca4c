// Compressing the pages of a volume, on several threads.
#include "PagedFileWriter.h"

#include "PageCodec.h"
#include "PageTable.h"
#include "VolumeHead.h"

#include "Support/ParallelFor.h"
#include "voxc/Support/WorkingMemory.h"

#include <algorithm>

namespace voxc {
namespace {

/// Compresses pages in runs, and appends them to a file in their order.
class PageAppender {
public:
  PageAppender(OutputFile &file, std::uint64_t end, const SaveOptions &options);

  /// The rows of the pages of a stream. Errors as `PagedFileWriter::finish`.
  Expected<std::vector<PageRow>> append(const Stream &stream);

  std::uint64_t end() const { return end_; }

private:
  Expected<void> appendRun(const Stream &stream, std::uint64_t begin, std::vector<PageRow> &rows);

  OutputFile &file_;
  std::uint64_t end_;
  const SaveOptions &options_;
  std::uint64_t pageBytes_;
  std::vector<PageEncoder> encoders_; ///< One for each page of a run.
};

/// As many as there are threads, but not more than have room in a bounded memory.
std::size_t encodersFor(const SaveOptions &options) {
  const std::uint64_t threads = threadsOrAll(options.threads);
  const std::uint64_t fit = options.memory ? options.memory->bound() / 4 / PageEncoder::kBytes : threads;
  return std::clamp<std::uint64_t>(fit, 1, threads);
}

PageAppender::PageAppender(OutputFile &file, std::uint64_t end, const SaveOptions &options)
    : file_(file), end_(end), options_(options), pageBytes_(options.pageBytes),
      encoders_(encodersFor(options)) {}

Expected<void> PageAppender::appendRun(const Stream &stream, std::uint64_t begin,
                                       std::vector<PageRow> &rows) {
  const auto run = stream.bytes.subspan(
      begin, std::min<std::uint64_t>(encoders_.size() * pageBytes_, stream.bytes.size() - begin));
  const std::uint64_t pages = (run.size() + pageBytes_ - 1) / pageBytes_;
  std::vector<std::span<const std::byte>> stored(pages);
  parallelFor(pages, static_cast<unsigned>(encoders_.size()), [&](std::uint64_t i) {
    const auto page =
        run.subspan(i * pageBytes_, std::min<std::uint64_t>(pageBytes_, run.size() - i * pageBytes_));
    stored[i] = encoders_[i].encode(page, stream.elementBytes);
  });
  for (const auto &page : stored) {
    VOXC_TRY(file_.write(page.data(), page.size()));
    Checksum checksum;
    checksum.add(page.data(), page.size());
    end_ += page.size();
    rows.push_back({end_, checksum.digest()});
  }
  if (options_.memory)
    options_.memory->relieve(run.size());
  return {};
}

Expected<std::vector<PageRow>> PageAppender::append(const Stream &stream) {
  std::vector<PageRow> rows;
  for (std::uint64_t begin = 0; begin < stream.bytes.size(); begin += encoders_.size() * pageBytes_) {
    VOXC_TRY(options_.progress.check());
    options_.progress.at("compress", static_cast<double>(begin) / static_cast<double>(stream.bytes.size()));
    VOXC_TRY(appendRun(stream, begin, rows));
  }
  return rows;
}

std::uint64_t pagesOf(std::span<const Stream> streams, std::uint64_t pageBytes) {
  std::uint64_t pages = 0;
  for (const Stream &stream : streams)
    pages += (stream.bytes.size() + pageBytes - 1) / pageBytes;
  return pages;
}

} // namespace

Expected<PagedFileWriter> PagedFileWriter::create(const std::string &path) {
  const bool isRegular = VOXC_TRY(OutputFile::isRegularAt(path));
  if (!isRegular)
    return Error::input("'" + path +
                        "' is no regular file, and a compressed volume can be written to such a one only");
  auto file = VOXC_TRY(OutputFile::create(path));
  return PagedFileWriter(path, std::move(file));
}

Expected<void> PagedFileWriter::finish(const VolumeInfo &info, std::span<const Stream> streams,
                                       const SaveOptions &options) {
  if (!isPageSize(options.pageBytes))
    return Error::usage("pages have a power of two of bytes, from 4 KiB to 1 MiB, not " +
                        std::to_string(options.pageBytes));
  Header header = headerOf(info, streams.size());
  header.version = kPagedVersion;
  header.headBytes = wholePages(header.textEnd() + pagesOf(streams, options.pageBytes) * sizeof(PageRow));
  const std::string room(header.headBytes, '\0');
  VOXC_TRY(file_.write(room.data(), room.size()));

  PageAppender appender(file_, header.headBytes, options);
  auto rows = layOut(streams, header.headBytes);
  std::string tables;
  for (std::size_t i = 0; i < streams.size(); ++i) {
    rows[i].pageBytes = options.pageBytes;
    rows[i].offset = appender.end();
    const auto pages = VOXC_TRY(appender.append(streams[i]));
    tables.append(reinterpret_cast<const char *>(pages.data()), pages.size() * sizeof(PageRow));
  }
  header.fileBytes = appender.end();

  std::string head = headText(header, rows, info) + tables;
  head.resize(header.headBytes);
  Checksum checksum;
  addAllButItself(checksum, std::as_bytes(std::span(head)));
  seal(head, checksum.digest());
  VOXC_TRY(file_.rewrite(0, head.data(), head.size()));
  VOXC_TRY(checkNoJournal(path_));
  return file_.commit();
}

} // namespace voxc
