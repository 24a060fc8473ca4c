// A volume as a page for browsers.
#include "common/ClipOptions.h"
#include "common/Files.h"
#include "common/PictureOptions.h"
#include "options/BuildArguments.h"
#include "page/CheckRays.h"
#include "page/FirstPages.h"
#include "page/Page.h"
#include "pictures/PictureRays.h"
#include "program/Applications.h"
#include "tracing/ErrorCheck.h"
#include "tracing/TraceSession.h"
#include "voxc/IR/Attribute.h"
#include "voxc/IR/Query.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Trace/PagedTracer.h"
#include "voxc/Volume/PagedVolume.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <vector>

namespace voxc::tool {
namespace {

/// Room for pages, where none is given: what browsers of any device have.
constexpr const char *kDefaultBudget = "128MiB";

/// Rays whose hits every browser is asked for; and those that tell the error of fast arithmetic.
constexpr std::size_t kChecked = 1024;
constexpr std::size_t kMeasured = 20000;

/// Large enough for its exposure to be that of a larger one.
constexpr const char *kPictureSize = "640x360";

/// True if what is level is level in the picture; a camera in units of a model is rounded.
bool isUpright(const Camera &camera) {
  const glm::dvec3 right = glm::cross(camera.look - camera.eye, camera.up);
  return std::abs(right.y) <= 1e-6 * glm::length(right);
}

/// The hits of rays by a kernel of this processor.
Expected<std::vector<Hit>> hitsOf(const Volume &volume, std::string_view precision,
                                  std::span<const Ray> rays) {
  Format format = volume.format();
  askForPrecision(format, precision);
  TraceSession tracing;
  tracing.choose(cpuDeviceInfo().name, 0);
  Json unused;
  VOXC_TRY(tracing.prepare(volume, format, unused));
  std::vector<Hit> hits(rays.size());
  if (Expected<TraceReport> traced = tracing.trace(rays, hits, {}); !traced)
    return traced.error();
  return hits;
}

/// What the exact hits of rays tell the page.
Expected<void> measure(const Volume &volume, const Progress &progress, page::PageContents &contents) {
  const std::vector<Ray> rays = page::checkRays(volume.info().extent, kMeasured);
  const auto oracle = VOXC_TRY(Oracle::of(volume, progress));
  const auto exact = VOXC_TRY(oracle.trace(rays, 0, progress));
  const auto fast = VOXC_TRY(hitsOf(volume, "fast", rays));
  contents.fast = compare(oracle, rays, exact, fast);
  const std::vector<Ray> checked = contents.streamed ? page::pictureRays(contents.streamed->view, kChecked)
                                                     : page::checkRays(volume.info().extent, kChecked);
  const std::vector<BoundedRay> kept =
      contents.clip.cutsNothing() ? std::vector<BoundedRay>() : contents.clip.bounded(checked, 0);
  const auto seen = VOXC_TRY(oracle.trace(kept.empty() ? RaySpan(checked) : RaySpan(kept), 0, progress));
  contents.checks = page::digestsOf(seen);
  return {};
}

/// The picture of a page, until it has one of its own.
Expected<TakenPicture> takePoster(const PictureOptions &options, const Volume &volume, const Clip &clip,
                                  const Progress &progress, Json &figures) {
  Format format = volume.format();
  if (!clip.cutsNothing())
    askForBounds(format);
  TraceSession tracing;
  tracing.choose(cpuDeviceInfo().name, 0);
  VOXC_TRY(tracing.prepare(volume, format, figures));
  PictureRays rays(tracing, 0, clip);
  const auto placed = VOXC_TRY(rays.findCamera(options, volume));
  RenderOptions rendering = renderOptions(options, volume);
  rendering.progress = progress;
  return rays.take(volume, placed, rendering);
}

class PageExport final : public PageWriter {
public:
  void declare(const CommandLine &command) override;
  bool isPage(const std::string &path) const override;
  Expected<void> check(const std::string &path) const override;
  Expected<void> write(const Volume &volume, const std::string &source, const std::string &path,
                       const Progress &progress, Json &figures) override;

private:
  bool isGiven() const;
  Expected<void> stream(const Volume &volume, const std::string &source, page::PageContents &contents) const;

  std::string title_;
  std::string url_;
  std::string budget_;
  PictureOptions picture_;
  ClipOptions clip_;
};

bool PageExport::isPage(const std::string &path) const {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
  return ending == ".html" || ending == ".htm";
}

void PageExport::declare(const CommandLine &command) {
  command.add("--title", title_, "What a page is called; the default is the name of the volume's file")
      .takes("TEXT");
  const Option url =
      command
          .add("--url", url_,
               "The page holds no words, but reads pages of the volume, which was stored with --compress, "
               "when rays need them: from this file beside it, or this address, by HTTP ranges")
          .takes("URL");
  command
      .add("--device-memory", budget_,
           "What a page with --url keeps on the device at most: pages and their table")
      .takes("SIZE")
      .check(sizeProblem)
      .needs(url)
      .showsDefault(kDefaultBudget);
  addViewOptions(command, picture_);
  addCameraPlace(command, picture_.camera);
  addClipOptions(command, clip_);
}

bool PageExport::isGiven() const {
  const CameraOptions &camera = picture_.camera;
  return !title_.empty() || !url_.empty() || !picture_.view.empty() || !picture_.sun.empty() ||
         !camera.camera.empty() || camera.fov != 0 || isOrthographic(camera) || camera.cubicVoxels ||
         clip_.isGiven();
}

Expected<void> PageExport::check(const std::string &path) const {
  if (!isPage(path) && isGiven())
    return Error::usage("'" + path +
                        "' is no page; --title, --url, --sun, cuts and what says where a picture is taken "
                        "from are for one, whose name ends in .html");
  if (const Expected<Clip> clip = clipOf(clip_); !clip)
    return clip.error();
  return checkPictureOptions(picture_);
}

Expected<void> PageExport::stream(const Volume &volume, const std::string &source,
                                  page::PageContents &contents) const {
  const auto file = VOXC_TRY(PagedVolume::open(source));
  // Browsers read the words as they are in the file, which begin with the first frame.
  std::vector<std::byte> first(file.streams().front().bytesOf(0));
  VOXC_TRY(file.decode(0, 0, first));
  if (std::memcmp(first.data(), volume.words().data(), sizeof(std::uint32_t)) != 0)
    return Error::usage("a page with --url shows the first frame alone; leave out the frame or --url");
  page::StreamedVolume streamed;
  streamed.url = url_;
  streamed.headBytes = file.headBytes();
  streamed.fileBytes = file.fileBytes();
  streamed.checksum = file.headChecksum();
  streamed.pageBytes = file.streams().front().pageBytes;
  streamed.memoryBytes = bytesOf(budget_.empty() ? kDefaultBudget : budget_);
  if (const std::uint64_t least = leastPagingBytes(file); streamed.memoryBytes < least)
    return Error::usage("--device-memory is too small for this volume: a ray needs up to " +
                        std::to_string(least) +
                        " bytes at once; give more, or store it with smaller pages (--page-bytes)");
  streamed.view = page::viewOf(contents.camera);
  streamed.first = VOXC_TRY(page::firstPages(volume, streamed.view, contents.clip, streamed.pageBytes));
  contents.streamed = std::move(streamed);
  return {};
}

Expected<void> PageExport::write(const Volume &volume, const std::string &source, const std::string &path,
                                 const Progress &progress, Json &figures) {
  auto clip = VOXC_TRY(clipOf(clip_, volume.info().voxelToModel));
  PictureOptions options = picture_;
  options.camera.size = kPictureSize;
  const auto taken = VOXC_TRY(takePoster(options, volume, clip, progress, figures));
  if (!isUpright(taken.placed.camera))
    return Error::usage("--camera \"" + options.camera.camera +
                        "\" is tilted; the way up of a page is +y, so leave out the third point");
  page::PageContents contents;
  contents.title = title_.empty() ? std::filesystem::path(source).stem().string() : title_;
  contents.camera = taken.placed.camera;
  contents.clip = page::scaled(std::move(clip));
  contents.sun = sunOf(options);
  contents.smooth = isSmoothSurface(volume.info());
  contents.exposure = taken.rendering.exposure;
  contents.picture = taken.rendering.picture;
  if (!url_.empty())
    VOXC_TRY(stream(volume, source, contents));
  VOXC_TRY(measure(volume, progress, contents));
  const auto page = VOXC_TRY(page::makePage(volume, contents));
  addCameraFigures(figures, options, taken.placed, volume);
  figures["exposure"] = contents.exposure;
  figures["fast_error"] = errorJson(contents.fast);
  return writeText(path, page);
}

} // namespace

std::unique_ptr<PageWriter> makePageWriter() { return std::make_unique<PageExport>(); }

} // namespace voxc::tool
