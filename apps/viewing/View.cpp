// voxc view: a window on a volume.
#include "viewing/SceneSource.h"

#include "program/Applications.h"
#include "view/Keys.h"
#include "view/Viewer.h"
#include "window/Window.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace voxc::tool {

namespace {

class ViewCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    source_.declare(command);
    addPictureOptions(command, picture_);
    addClipOptions(command, clip_);
    command.option("--samples").text("Rays through each pixel of the finest picture; default: 16");
    command.option("--size").text("Pixels of the window; the default is the camera file's, or 1280x720");
    command.add("--search", search_, "Shows what voxc search measured as a chart, whose points load formats")
        .takes("DIR");
    command.add("--screenshots", screenshots_, "Folder that pictures and volumes are written to")
        .takes("DIR")
        .showsDefault();
    command.add("--fps", framesPerSecond_, "Frames of an animation that are played in a second")
        .takes("N")
        .between(0.01, 1000.0)
        .showsDefault();
    command.add("--log", log_, "Writes all that happens, with its time, to a file").takes("FILE");
    addCommonOptions(command, common_);
    command.remove(command.option("--stats")); // There is no end of which figures would tell.
    command.footer("Keys and the mouse:\n" + view::keysHelp());
  }

  Expected<void> run() override {
    VOXC_TRY(checkPictureOptions(picture_));
    VOXC_TRY(source_.check());
    if (const Expected<Clip> clip = clipOf(clip_); !clip)
      return clip.error();
    if (clip_.isGiven() && source_.memory().allowedCoarse() > 0)
      return Error::usage("--clip-box and --clip-plane show voxels alone; leave out --allow-coarse");
    if (clip_.isGiven())
      source_.useBounds();
    picture_.coarse = source_.memory().allowedCoarse();
    if (std::error_code ignored; !std::filesystem::is_directory(screenshots_, ignored))
      return Error::usage("--screenshots " + screenshots_ + " is no folder");
    const auto camera = VOXC_TRY(makeCamera(picture_.camera, {1, 1, 1}));
    view::ViewerOptions options{.picture = picture_,
                                .clip = clip_,
                                .width = camera.width,
                                .height = camera.height,
                                .wish = source_.wish(),
                                .devices = deviceNames(),
                                .screenshots = screenshots_,
                                .framesPerSecond = framesPerSecond_};
    if (!search_.empty())
      options.search = VOXC_TRY(view::readSearchPoints(search_));
    auto log = VOXC_TRY(view::EventLog::open(common_.quiet ? nullptr : stdout, log_));
    // Lavapipe reads this once, when it is first loaded, which the window may do.
    if (source_.threads() > 0)
      ::setenv("LP_NUM_THREADS", std::to_string(source_.threads()).c_str(), 1);
    return view::runWindow("voxc view " + source_.input(), std::move(options), source_.maker(common_), log);
  }

private:
  SceneSource source_;
  PictureOptions picture_;
  ClipOptions clip_;
  std::string search_, screenshots_ = ".", log_;
  double framesPerSecond_ = view::ViewerOptions().framesPerSecond;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeViewCommand() { return std::make_unique<ViewCommand>(); }

bool opensWindows() { return view::hasWindows(); }

} // namespace voxc::tool
