// Work that is stopped at its n-th look, for every n: nothing of it may pass for the whole.
#include "Source/SourceTesting.h"

#include "voxc/Construct/Constructor.h"
#include "voxc/Construct/Split.h"
#include "voxc/Render/NormalAttribute.h"
#include "voxc/Source/Export.h"
#include "voxc/Source/Sources.h"
#include "voxc/Support/File.h"
#include "voxc/Support/Next.h"

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>
#include <type_traits>

namespace voxc {
namespace {

// A loop whose condition is a stream's next does not compile: a stop is not the end.
static_assert(!std::is_constructible_v<bool, Next<int>>);

constexpr int kStoppedSide = 17; // Of bricks of 8, three on each axis.
constexpr const char *kEarlier = "what was there before";

/// When to stop: at the n-th look, whoever looks.
struct Countdown {
  std::uint64_t until = 0;
  std::atomic<std::uint64_t> looks = 0;

  bool isOver() { return looks++ >= until; }
};

/// How a source ends before its end.
enum class Stop {
  Fails,  ///< It cannot make its voxels any more.
  Stopped ///< The work's flag is set, and the source goes on if it is asked.
};

/// A source that stops at its n-th cube, counted over all of its views.
class StoppingSource final : public VoxelSource {
public:
  StoppingSource(std::unique_ptr<VoxelSource> source, std::shared_ptr<Countdown> countdown, Stop stop,
                 std::shared_ptr<std::atomic<bool>> flag)
      : source_(std::move(source)), countdown_(std::move(countdown)), stop_(stop), flag_(std::move(flag)) {}

  Int3 extent() const override { return source_->extent(); }
  int log2Chunk() const override { return 3; }
  std::unique_ptr<VoxelSource> view() const override {
    return std::make_unique<StoppingSource>(source_->view(), countdown_, stop_, flag_);
  }
  bool empty(const Cube &cube) override { return look() && source_->empty(cube); }
  Expected<void> read(const Cube &cube, std::uint32_t *words) override {
    return look() ? source_->read(cube, words) : Expected<void>(Error::environment("the disk is gone"));
  }

private:
  /// False once it has failed.
  bool look() {
    if (!countdown_->isOver())
      return true;
    if (stop_ == Stop::Stopped)
      *flag_ = true;
    return stop_ == Stop::Stopped;
  }

  std::unique_ptr<VoxelSource> source_;
  std::shared_ptr<Countdown> countdown_;
  Stop stop_;
  std::shared_ptr<std::atomic<bool>> flag_;
};

class Stops : public ::testing::Test {
protected:
  static constexpr const char *kFormat = "R(1^3) G(4)";

  std::string bytesOf(const std::string &path) const {
    const auto text = readTextFile(path);
    return text ? *text : "";
  }
  /// Made in cubes as small as may be, so that it has many parts.
  std::unique_ptr<VoxelSource> scene(std::shared_ptr<Countdown> countdown = nullptr, Stop stop = Stop::Fails,
                                     std::shared_ptr<std::atomic<bool>> flag = nullptr) const {
    if (!countdown)
      countdown = std::make_shared<Countdown>(~std::uint64_t{0});
    return std::make_unique<StoppingSource>(*makeBuiltinSource("terrain", kStoppedSide), std::move(countdown),
                                            stop, std::move(flag));
  }
  std::string fragment(int i) const { return folder_.path("part" + std::to_string(i)); }
  std::vector<std::string> fragments() const { return {fragment(0), fragment(1), fragment(2)}; }

  void buildFragments() {
    const auto source = scene();
    for (int i = 0; i < 3; ++i)
      ASSERT_TRUE(constructor_.buildFragment(*source, std::uint64_t(i), 3, fragment(i)));
  }

  using Work = std::function<Expected<void>(const std::string &path, const Progress &progress)>;

  /// Does the work once to its end, and then stopped at every look until it is not stopped any more.
  void stopEverywhere(const Work &work, const char *ending = ".out") {
    const std::string whole = folder_.path(std::string("whole") + ending);
    const std::string path = folder_.path(std::string("stopped") + ending);
    ASSERT_TRUE(work(whole, {}));
    int stopped = 0;
    for (std::uint64_t n = 0; n < kMostLooks; ++n) {
      folder_.file(std::string("stopped") + ending, kEarlier);
      Countdown countdown{.until = n};
      const auto done = work(path, {.ask = [&] { return countdown.isOver(); }});
      if (done && countdown.looks <= n) {
        EXPECT_TRUE(bytesOf(path) == bytesOf(whole));
        EXPECT_GT(stopped, 0) << "nobody looks whether to stop";
        return;
      }
      expectWholeOrEarlier(done, path, bytesOf(whole), ErrorKind::Interrupted);
      stopped += !done;
    }
    FAIL() << "it never came to its end";
  }

  /// Builds from a source that stops at every one of its cubes.
  using Build =
      std::function<Expected<void>(VoxelSource &source, const std::string &path, const Progress &progress)>;
  void stopSourceEverywhere(const Build &build, Stop stop) {
    const std::string whole = folder_.path("whole");
    const std::string path = folder_.path("stopped");
    ASSERT_TRUE(build(*scene(), whole, {}));
    for (std::uint64_t n = 0; n < kMostLooks; ++n) {
      folder_.file("stopped", kEarlier);
      const auto countdown = std::make_shared<Countdown>(n);
      const auto flag = std::make_shared<std::atomic<bool>>(false);
      const auto done = build(*scene(countdown, stop, flag), path, {.stop = flag.get()});
      expectWholeOrEarlier(done, path, bytesOf(whole),
                           stop == Stop::Fails ? ErrorKind::Environment : ErrorKind::Interrupted);
      if (countdown->looks <= n) {
        EXPECT_TRUE(done);
        return;
      }
      // What has failed is told; what was stopped may have ended all the same.
      ASSERT_FALSE(done && stop == Stop::Fails)
          << "a source that failed at cube " << n << " passes for whole";
    }
    FAIL() << "it never came to its end";
  }

  void stopSourceEverywhere(const Build &build) {
    for (const Stop stop : {Stop::Fails, Stop::Stopped})
      stopSourceEverywhere(build, stop);
  }

  Build builds(unsigned threads, bool compress = false) {
    return [=, this](VoxelSource &source, const std::string &path, const Progress &progress) {
      const auto built = constructor_.build(
          source, {.threads = threads, .path = path, .progress = progress, .compress = compress});
      return built ? Expected<void>() : built.error();
    };
  }
  Build buildsFragment(unsigned threads) {
    return [=, this](VoxelSource &source, const std::string &path, const Progress &progress) {
      const auto built =
          constructor_.buildFragment(source, 0, 1, path, {.threads = threads, .progress = progress});
      return built ? Expected<void>() : built.error();
    };
  }

  TemporaryFolder folder_;
  Constructor constructor_ = std::move(*Constructor::compile(*parseFormat(kFormat)));

private:
  static constexpr std::uint64_t kMostLooks = 10000;

  void expectWholeOrEarlier(const Expected<void> &done, const std::string &path, const std::string &whole,
                            ErrorKind kind) const {
    EXPECT_TRUE(bytesOf(path) == (done ? whole : kEarlier));
    EXPECT_TRUE(done || done.error().kind == kind) << done.error().message;
  }
};

TEST_F(Stops, InSourcesOfABuild) {
  stopSourceEverywhere(builds(1));
  stopSourceEverywhere(builds(3));
  stopSourceEverywhere(builds(2, true));
}

TEST_F(Stops, InSourcesOfAFragment) {
  stopSourceEverywhere(buildsFragment(1));
  stopSourceEverywhere(buildsFragment(3));
}

TEST_F(Stops, InBuilds) {
  for (const Build &build : {builds(1), builds(3), builds(1, true), buildsFragment(1), buildsFragment(2)})
    stopEverywhere(
        [&](const std::string &path, const Progress &progress) { return build(*scene(), path, progress); });
}

TEST_F(Stops, InMerges) {
  buildFragments();
  stopEverywhere([&](const std::string &path, const Progress &progress) -> Expected<void> {
    const auto merged = constructor_.merge(fragments(), {.path = path, .progress = progress});
    return merged ? Expected<void>() : merged.error();
  });
}

TEST_F(Stops, InJoins) {
  buildFragments();
  FragmentShare all;
  all.end = partNumbersOf(*scene(), *parseFormat(kFormat)).count;
  stopEverywhere([&](const std::string &path, const Progress &progress) -> Expected<void> {
    const auto joined = constructor_.joinFragments(fragments(), all, path, {.progress = progress});
    return joined ? Expected<void>() : joined.error();
  });
}

class StopsOfVolumes : public Stops {
protected:
  StopsOfVolumes()
      : volume_(std::make_shared<const Volume>(std::move(constructor_.build(*scene())->volume))) {}

  std::shared_ptr<const Volume> volume_;
};

TEST_F(StopsOfVolumes, InSplits) {
  stopEverywhere([&](const std::string &path, const Progress &progress) -> Expected<void> {
    const auto split = splitVolume(*volume_, 0, 1, path, progress);
    return split ? Expected<void>() : split.error();
  });
}

TEST_F(StopsOfVolumes, InEdits) {
  const std::vector<VoxelEdit> edits = {{{3, 3, 3}, {9, 9, 9}, 0xff112233, nullptr}};
  stopEverywhere([&](const std::string &path, const Progress &progress) -> Expected<void> {
    const auto edited = constructor_.edit(volume_, edits, {.path = path, .progress = progress});
    return edited ? Expected<void>() : edited.error();
  });
}

TEST_F(StopsOfVolumes, InAttributes) {
  stopEverywhere([&](const std::string &path, const Progress &progress) -> Expected<void> {
    auto normals = normalAttribute(*volume_, 2, progress);
    if (!normals)
      return normals.error();
    const auto attached = withAttribute(volume_, std::move(*normals));
    return attached ? attached->save(path, {.compress = true, .progress = progress}) : attached.error();
  });
}

TEST_F(StopsOfVolumes, InExportsAndPages) {
  for (const ExportFormat &format : exportFormats()) {
    SCOPED_TRACE(format.ending);
    if (format.ending == ".hvx" || format.ending == ".png" || format.ending == ".vdb")
      continue;
    stopEverywhere(
        [&](const std::string &path, const Progress &progress) -> Expected<void> {
          const auto exported = exportVoxels(*volume_, path, {.save = {.progress = progress}, .lossy = true});
          return exported ? Expected<void>() : exported.error();
        },
        std::string(format.ending).c_str());
  }
  stopEverywhere([&](const std::string &path, const Progress &progress) {
    return volume_->save(path, {.compress = true, .pageBytes = 4096, .threads = 2, .progress = progress});
  });
}

/// A set of files is read from its number 0 or 1 on: stopped, it has neither.
TEST_F(StopsOfVolumes, InSetsOfFiles) {
  constexpr std::uint64_t kEncodedFirst = kStoppedSide & -8; // Whole cubes of 8.
  std::uint64_t stopped = 0;
  for (std::uint64_t n = 0;; ++n) {
    const TemporaryFolder folder;
    folder.file("s0.png", kEarlier);
    Countdown countdown{.until = n};
    const auto exported =
        exportVoxels(*volume_, folder.path("s%d.png"),
                     {.save = {.threads = 1, .progress = {.ask = [&] { return countdown.isOver(); }}}});
    if (exported) {
      EXPECT_EQ(folder.count(), kStoppedSide);
      break;
    }
    ++stopped;
    EXPECT_TRUE(bytesOf(folder.path("s0.png")) ==
                (n < kEncodedFirst + 4 ? kEarlier : "")); // Until its third file.
    EXPECT_EQ(bytesOf(folder.path("s1.png")), "");
  }
  EXPECT_EQ(stopped, 2 * kStoppedSide + 1); // Before all, before each is encoded, and before each is written.
}

} // namespace
} // namespace voxc
