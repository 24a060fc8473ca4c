// The viewer without a window: input goes in, pictures and lines come out.
#include "Hill.h"

#include "view/Viewer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace voxc::view {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class ViewerTest : public ::testing::Test {
protected:
  ViewerTest()
      : folder_(std::filesystem::temp_directory_path() / ("voxc-view-" + std::to_string(::getpid()))) {
    std::filesystem::create_directories(folder_);
    log_ = std::make_unique<EventLog>(*EventLog::open(nullptr, (folder_ / "log").string()));
  }
  ~ViewerTest() override {
    viewer_.reset();
    std::filesystem::remove_all(folder_);
  }

  void begin(ViewerOptions options = {}, SceneMaker maker = hillMaker()) {
    options.width = 64;
    options.height = 48;
    options.picture.style = "flat";
    options.picture.camera.size = "64x48";
    options.devices = {"cpu", "other", "broken"};
    options.screenshots = folder_.string();
    viewer_ = std::make_unique<Viewer>(std::move(options), std::move(maker), *log_, [] {});
  }

  /// Goes on until the log has a line with this, after what was waited for before.
  std::string wait(const std::string &part) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
    while (std::chrono::steady_clock::now() < end) {
      viewer_->advance(0.01);
      if (viewer_->takePicture())
        viewer_->presented();
      std::ifstream file(folder_ / "log");
      file.seekg(position_);
      for (std::string line; std::getline(file, line);) {
        position_ = file.tellg();
        if (line.find(part) != std::string::npos)
          return line.substr(10);
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ADD_FAILURE() << "no line with " << part;
    return {};
  }

  /// The line that says that the picture on the screen is as fine as it gets.
  std::string finest() {
    std::string line = wait("the finest");
    while (!line.starts_with("shown") && !HasFailure())
      line = wait("the finest");
    return line;
  }

  std::filesystem::path folder_;
  std::unique_ptr<EventLog> log_;
  std::streamoff position_ = 0;
  std::unique_ptr<Viewer> viewer_;
};

TEST_F(ViewerTest, ShowsTheFirstSceneUntilItIsFine) {
  begin();
  EXPECT_THAT(wait("scene"), StartsWith("scene R(4, 4, 4) on cpu: 16 x 16 x 16, "));
  EXPECT_THAT(finest(), StartsWith("shown 64x48, 16 samples"));
  EXPECT_EQ(viewer_->state().device, "cpu");
  EXPECT_THAT(viewer_->state().picture, StartsWith("64x48, 16 samples"));
  EXPECT_EQ(viewer_->state().work, "");
}

TEST_F(ViewerTest, LoadsAFormatAndKeepsTheSceneIfItCannot) {
  begin();
  finest();
  viewer_->load("R(2^3) S(2)");
  EXPECT_THAT(wait("scene"), StartsWith("scene R(2, 2, 2) S(2) on cpu"));
  for (const char *wrong : {"R(2^3", "S(2)", "G(4) --nonsense"}) {
    viewer_->load(wrong);
    wait("error");
    EXPECT_EQ(viewer_->state().format, "R(2, 2, 2) S(2)");
    EXPECT_NE(viewer_->state().error, "");
  }
  viewer_->load("G(4) --whole-level-dedup");
  EXPECT_THAT(wait("scene"), StartsWith("scene G(4) --whole-level-dedup"));
  EXPECT_EQ(viewer_->state().error, "");
  EXPECT_FALSE(viewer_->failure());
}

TEST_F(ViewerTest, GoesThroughTheDevices) {
  begin();
  finest();
  viewer_->press(Action::NextDevice);
  EXPECT_THAT(wait("scene"), HasSubstr(" on other"));
  viewer_->press(Action::NextDevice);
  wait("error there is no such device");
  EXPECT_EQ(viewer_->state().device, "other");
  viewer_->press(Action::NextDevice);
  EXPECT_THAT(wait("scene"), HasSubstr(" on cpu"));
}

TEST_F(ViewerTest, FailsIfTheFirstSceneDoes) {
  ViewerOptions options;
  options.wish.device = "broken";
  begin(std::move(options));
  while (!viewer_->failure())
    viewer_->advance(0.01);
  EXPECT_EQ(viewer_->failure()->message, "there is no such device");
}

TEST_F(ViewerTest, KeysChooseStyles) {
  begin();
  finest();
  viewer_->press(Action::StyleNormals);
  EXPECT_EQ(wait("style"), "style normals");
  viewer_->press(Action::ToggleHeatmap);
  EXPECT_EQ(wait("style"), "style heatmap");
  viewer_->press(Action::ToggleHeatmap);
  EXPECT_EQ(wait("style"), "style normals");
  finest();
  EXPECT_EQ(viewer_->state().style, Style::Normals);
}

TEST_F(ViewerTest, MovesAndReturnsHome) {
  begin();
  finest();
  const auto camera = [this] {
    viewer_->press(Action::CopyCamera);
    return wait("camera");
  };
  const std::string home = camera();
  EXPECT_THAT(home, StartsWith("camera --camera "));
  EXPECT_EQ("camera " + *viewer_->takeCopied(), home);
  EXPECT_FALSE(viewer_->takeCopied());
  std::string last = home;
  const auto expectMoved = [&] {
    viewer_->advance(0.01);
    const std::string now = camera();
    EXPECT_NE(now, last);
    last = now;
  };
  viewer_->press(Action::Forward);
  viewer_->release(Action::Forward);
  expectMoved();
  viewer_->drag(10, 5, false);
  expectMoved();
  viewer_->drag(10, 5, true);
  expectMoved();
  viewer_->zoom(2);
  expectMoved();
  viewer_->press(Action::ToggleFly);
  viewer_->drag(10, 5, false);
  expectMoved();
  viewer_->press(Action::Home);
  EXPECT_EQ(camera(), home);
  EXPECT_THAT(wait("painted"), HasSubstr("painted"));
}

TEST_F(ViewerTest, WhatIsDraggedFollowsTheMouse) {
  ViewerOptions options;
  options.picture.camera.camera = "8,8,40:8,8,8"; // Looks along -z, and +x is to the right.
  begin(std::move(options));
  finest();
  const auto points = [this] {
    viewer_->press(Action::CopyCamera);
    std::array<double, 6> numbers{};
    std::sscanf(wait("camera").c_str(), "camera --camera %lf,%lf,%lf:%lf,%lf,%lf", &numbers[0], &numbers[1],
                &numbers[2], &numbers[3], &numbers[4], &numbers[5]);
    return numbers;
  };
  viewer_->drag(10, 10, false);
  EXPECT_LT(points()[0], 8);
  EXPECT_GT(points()[1], 8);
  viewer_->press(Action::Home);
  viewer_->drag(10, 10, true);
  EXPECT_LT(points()[0], 8);
  EXPECT_GT(points()[1], 8);
  viewer_->press(Action::Home);
  viewer_->press(Action::ToggleFly);
  viewer_->drag(10, 10, false);
  EXPECT_LT(points()[3], 8);
  EXPECT_GT(points()[4], 8);
}

TEST_F(ViewerTest, AClickTellsAndCanBeOrbited) {
  begin();
  finest();
  viewer_->click(32, 30);
  EXPECT_THAT(wait("picked"), StartsWith("picked voxel "));
  EXPECT_THAT(viewer_->state().picked, HasSubstr("the oracle agrees"));
  viewer_->press(Action::Orbit);
  viewer_->click(32, 24);
  // What is looked at is in the middle now, or behind what is nearer.
  EXPECT_THAT(wait("picked"), StartsWith("picked voxel "));
  viewer_->click(64, 0);
  viewer_->click(-1, 0);
}

TEST_F(ViewerTest, WritesScreenshotsBesideEachOther) {
  begin();
  finest();
  viewer_->press(Action::Screenshot);
  viewer_->press(Action::Screenshot);
  wait("screenshot");
  wait("screenshot");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "voxc-0001.png"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "voxc-0002.png"));
}

TEST_F(ViewerTest, AnotherSizeIsPaintedAnew) {
  begin();
  finest();
  viewer_->resize(30, 20);
  EXPECT_THAT(finest(), HasSubstr("30x20"));
  viewer_->resize(0, 0);
  viewer_->press(Action::NextView);
  EXPECT_EQ(wait("view"), "view iso");
  EXPECT_THAT(finest(), HasSubstr("30x20"));
}

TEST_F(ViewerTest, GoesAlongTheFrontierOfASearch) {
  ViewerOptions options;
  options.search.points = {{"G(4)", 100, 1, true}, {"S(4)", 200, 0.5, false}, {"R(4, 4, 4)", 300, 2, true}};
  begin(std::move(options));
  finest();
  viewer_->press(Action::PreviousPoint); // From the format that is shown.
  EXPECT_THAT(wait("scene"), StartsWith("scene G(4) on"));
  viewer_->press(Action::NextPoint);
  EXPECT_THAT(wait("scene"), StartsWith("scene R(4, 4, 4) on"));
  viewer_->press(Action::PreviousPoint);
  EXPECT_THAT(wait("scene"), StartsWith("scene G(4) on"));
}

TEST_F(ViewerTest, InputBeforeTheFirstSceneIsHarmless) {
  begin();
  for (const KeyKind &kind : keyKinds()) {
    viewer_->press(kind.action);
    viewer_->release(kind.action);
  }
  viewer_->drag(1, 1, false);
  viewer_->zoom(1);
  viewer_->click(1, 1);
  finest();
}

TEST_F(ViewerTest, EscapeClosesWhenItIsPressedTwiceInTurn) {
  begin();
  viewer_->press(Action::Escape);
  EXPECT_TRUE(viewer_->state().isLeaving);
  viewer_->press(Action::StyleDepth);
  EXPECT_FALSE(viewer_->state().isLeaving);
  viewer_->press(Action::ToggleHelp);
  viewer_->press(Action::Escape);
  EXPECT_FALSE(viewer_->state().showsHelp);
  EXPECT_FALSE(viewer_->state().isLeaving);
  viewer_->press(Action::Escape);
  EXPECT_FALSE(viewer_->state().isClosing);
  viewer_->press(Action::Escape);
  EXPECT_TRUE(viewer_->state().isClosing);
}

TEST_F(ViewerTest, EscapeEndsLoading) {
  SceneMaker maker = hillMaker();
  maker.makeModel = [make = maker.makeModel](const std::string &text,
                                             const Progress &progress) -> Expected<Model> {
    while (text == "S(4)" && !progress.stopped())
      progress.at("build", 0.5);
    return make(text, progress);
  };
  begin({}, std::move(maker));
  finest();
  viewer_->load("S(4)");
  viewer_->advance(0.01);
  EXPECT_NE(viewer_->state().work, "");
  viewer_->press(Action::Escape);
  EXPECT_EQ(wait("stopped"), "stopped loading S(4)");
  for (int i = 0; i < 20; ++i) {
    viewer_->advance(0.01);
    EXPECT_EQ(viewer_->state().work, "");
  }
  EXPECT_EQ(viewer_->state().format, "R(4, 4, 4)");
  EXPECT_FALSE(viewer_->state().isLeaving);
  viewer_->load("G(4)");
  EXPECT_THAT(wait("scene"), StartsWith("scene G(4)"));
}

TEST_F(ViewerTest, FliesFirstWhereTheEyeIsInside) {
  ViewerOptions options;
  options.picture.camera.camera = "8,8,8:8,4,0";
  begin(std::move(options));
  EXPECT_EQ(wait("mode"), "mode fly");
  EXPECT_TRUE(viewer_->state().isFlying);
  viewer_->press(Action::NextView);
  EXPECT_EQ(wait("mode"), "mode orbit");
}

} // namespace
} // namespace voxc::view
