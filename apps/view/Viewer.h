// The viewer without its window: what is shown, what input does to it, and what threads bring.
#pragma once

#include "view/Carving.h"
#include "view/EventLog.h"
#include "view/Motion.h"
#include "view/NumberedFiles.h"
#include "view/OracleCheck.h"
#include "view/Painter.h"
#include "view/PrefetchThread.h"
#include "view/SearchPoints.h"

#include "common/ClipOptions.h"
#include "common/PictureOptions.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace voxc::view {

struct ViewerOptions {
  tool::PictureOptions picture;
  tool::ClipOptions clip; ///< If given, the kernels of scenes have bounds.
  int width = 1280, height = 720;
  SceneWish wish;                   ///< The first scene.
  std::vector<std::string> devices; ///< Names that a scene may wish for.
  SearchPoints search;              ///< Empty: none.
  std::string screenshots;          ///< The folder that they and volumes are written to.
  double framesPerSecond = 12;      ///< Of an animation.
};

/// What the panel shows. Texts are "" where there is nothing to say.
struct ViewerState {
  Style style = Style::Lit;
  std::string format, device;        ///< Of the scene.
  std::string size;                  ///< Of its volume, in words.
  std::string work;                  ///< What is being loaded, and how far.
  std::string error;                 ///< Of what was asked for last.
  std::string picture;               ///< How fine it is.
  std::string picked;                ///< What a click told.
  std::string brush;                 ///< What the mouse edits; "": it turns.
  std::size_t frame = 0, frames = 1; ///< Of an animation.
  bool isFlying = false;
  bool showsPanel = true, showsHelp = false;
  bool isLeaving = false; ///< Escape was pressed where it ends nothing: once more, and it closes.
  bool isClosing = false;
};

class Viewer {
public:
  /// Begins to load the first scene. `wake` is called from threads whenever `advance` has something to do.
  /// `log` must outlive it.
  Viewer(ViewerOptions options, SceneMaker maker, EventLog &log, std::function<void()> wake);

  void press(Action action);
  void release(Action action) { motion_.release(action); }
  void releaseKeys() { motion_.releaseAll(); }
  /// The mouse moved by so many pixels with a button down.
  void drag(double right, double down, bool isMoving);
  /// The wheel turned by so many steps, away from the user.
  void zoom(double steps);
  /// Asks what is to be seen at a pixel.
  void click(int column, int row);
  void resize(int width, int height);
  /// Whether the mouse edits; a stroke of the brush at a pixel: the first of a drag, or one more.
  bool isBrushing() const { return brush_.kind != BrushKind::None; }
  void stroke(int column, int row, bool isFirst);

  void setStyle(Style style);
  /// Loads a format, with passes, or the scene on another device. What is shown stays until it is there, and
  /// for good if it fails.
  void load(const std::string &format);
  void useDevice(const std::string &device);

  /// Goes on by so many seconds: moves by held keys, takes what threads brought. True if there is something
  /// new to be seen.
  bool advance(double seconds);
  /// Whether something moves: keys are held, or frames are played.
  bool isMoving() const { return motion_.isMoving() || isPlaying_; }
  /// Shows a frame of an animation, from 0 on, and stops playing.
  void showFrame(std::size_t index);
  bool isPlaying() const { return isPlaying_; }

  /// Why there is nothing to see, and will not be: the first scene failed.
  const std::optional<Error> &failure() const { return failure_; }
  const ViewerState &state() const { return state_; }
  const ViewerOptions &options() const { return options_; }
  /// The newest picture, if it was not taken yet; else null. It stays until the next `advance`.
  const Picture *takePicture();
  /// What was taken is on its way to the screen: tells the log how long an input took until then.
  void presented();
  /// A text for the clipboard, once.
  std::optional<std::string> takeCopied() { return std::exchange(copied_, std::nullopt); }
  /// The format is being written.
  void startedWriting() { log_.note("writing"); }
  /// It is so no more, whether it was entered or left.
  void stoppedWriting() { log_.note("wrote"); }
  /// Whether the user wants to write a format, once.
  bool takeEditing() { return std::exchange(isEditing_, false); }

private:
  /// What the loading thread brings.
  struct Loaded {
    Expected<std::shared_ptr<Scene>> scene;
    std::optional<tool::PlacedCamera> placed; ///< With the first scene.
  };

  bool isPlaced() const { return scene_ && camera_; }
  void request(const SceneWish &wish);
  void takeLoaded(Loaded loaded);
  void stopLoading();
  void leave(bool isSure);
  void takePainting(Painting painting);
  void takePick(const Expected<Pick> &pick);
  void takeCamera(const Expected<Camera> &camera);
  Shot shot() const;
  void show();
  void fail(const Error &error);
  void nextView();
  void toggleOrthographic();
  void nextDevice();
  void nextPoint(int step);
  void orbitTouched();
  void setCamera(const ViewCamera &camera);
  void setFlying(bool isFlying);
  bool isInside(const Camera &camera) const;
  void setBrush(const Brush &brush);
  void nextBrush();
  void toggleBrushShape();
  void resizeBrush(int by);
  void takeBrushColour();
  void copyUnderBrush();
  void takeCut(const Expected<std::shared_ptr<const Volume>> &cut);
  void act(Deed deed);
  void takeCarving(const Expected<Carving> &carving);
  void chooseFrame(std::size_t index);
  void stepFrame(int by);
  void setPlaying(bool isPlaying);
  void playOn(double seconds);
  void saveVolume();
  void takeSaved(const Expected<std::string> &path);
  void copyCamera();
  void writeScreenshot();
  void takeScreenshot(const Expected<std::string> &path);

  ViewerOptions options_;
  SceneMaker maker_;
  EventLog &log_;
  std::function<void()> wake_;
  ViewerState state_;
  SceneWish wish_; ///< The last that was asked for.
  std::optional<Error> failure_;
  std::shared_ptr<Scene> scene_;
  std::optional<ViewCamera> camera_;
  std::optional<ViewCamera> home_;
  Motion motion_;
  Style styleBefore_ = Style::Lit; ///< The heat map.
  std::size_t view_ = 0;           ///< The last word that `nextView` took.
  std::optional<Hit> touched_;
  Picture picture_;
  std::string fineness_;                              ///< Of it, for the log.
  std::uint64_t pictureNumber_ = 0, takenNumber_ = 0; ///< Of the shots that it, and what was taken, is of.
  bool isPictureNew_ = false;
  std::optional<std::string> copied_;
  bool isEditing_ = false;
  bool isLoading_ = false;
  std::string shot_; ///< How fine the last screenshot is.

  /// An input that was not seen yet.
  struct Waiting {
    std::uint64_t number;
    Stopwatch watch;
  };
  std::optional<Waiting> waiting_;
  std::optional<Stopwatch> acted_; ///< Since a brush did what no picture shows yet.
  Brush brush_;
  std::size_t edits_ = 0, editsAtLoad_ = 0; ///< That were asked for or done; and when a load was begun.
  bool isPlaying_ = false;
  double playedSeconds_ = 0; ///< Since the frame was chosen.

  LatestValue<Loaded> loaded_;
  LatestValue<std::string> work_;
  LatestValue<Expected<Pick>> pick_;
  LatestValue<Expected<Camera>> placed_;
  LatestValue<Expected<Carving>> carving_;
  LatestValue<Expected<std::shared_ptr<const Volume>>> cut_;
  NumberedFiles screenshots_, volumes_;
  OracleCheck oracleCheck_;
  Painter painter_;
  PrefetchThread prefetch_;
  JobThread loader_; // Threads last: they use all others.
};

} // namespace voxc::view
