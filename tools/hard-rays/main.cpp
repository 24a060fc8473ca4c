// voxc-hard-rays: kernels of many formats against the exact oracle, on rays that are hard to trace.
#include "hard-rays/HardRayFormats.h"
#include "hard-rays/HardRaySweep.h"

#include "common/Command.h"
#include "common/CommandLine.h"
#include "common/Interrupt.h"
#include "common/Statistics.h"
#include "common/Terminal.h"
#include "options/Figures.h"
#include "testing/HardRays.h"
#include "voxc/Support/File.h"

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <optional>

namespace voxc::tool {
namespace {

class HardRays {
public:
  void declare(const CommandLine &command);
  Expected<void> run();

private:
  Expected<HardRayBudget> readBudget() const;
  Expected<std::uint64_t> readSeed() const;
  Expected<void> sweep(HardRaySweep &sweep) const;
  void addFigures(const HardRaySweep &sweep, const HardRayReport &report, Json &figures) const;

  HardRayFormats formats_;
  HardRayScenes scenes_;
  TracingDevices devices_;
  SweepSize size_{.rays = 1000000, .seconds = 0, .seed = 1, .scenes = 4};
  std::optional<std::uint64_t> seed_;
  std::string budget_;
  std::string corpus_;
  bool list_ = false;
  HardRayReport::Rules rules_;
  CommonOptions common_;
};

void HardRays::declare(const CommandLine &command) {
  scenes_.declare(command);
  formats_.declare(command);
  command.add("--scenes", size_.scenes, "Scenes for each format, which takes them in turn; 0: all")
      .takes("N")
      .between(std::uint64_t{0}, std::uint64_t{1} << 20)
      .showsDefault();
  command.add("--rays", size_.rays, "Rays in all, over all formats, scenes and devices")
      .takes("N")
      .between(std::uint64_t{1}, std::uint64_t{1} << 50)
      .showsDefault();
  command
      .add("--seconds", size_.seconds,
           "Do it again and again, each time with other rays, until so much time has passed")
      .takes("S")
      .positive();
  command
      .add("--seed", seed_,
           "Another number makes other rays and other random formats; default: $VOXC_SEED, or 1")
      .takes("N")
      .between(std::uint64_t{0}, std::uint64_t{1} << 62);
  command.addFlag("--ray-bounds", size_.bounds,
                  "Give each ray a tmin and a tmax, at and beside the moments at which it enters voxels");
  command.add("--budget", budget_, "Weights of classes and scenes; default: those of docs/hard-rays.md")
      .takes("FILE");
  command.add("--corpus", corpus_, "Trace the rays of this file, whose exact hits stand beside them, instead")
      .takes("FILE");
  command.addFlag("--list", list_, "Print the classes, and do nothing else");
  command.addFlag("--allow-boundary", rules_.allowBoundary,
                  "Accept, but still count, differences that float rounding at a cell's boundary explains");
  command.add("--max-ulp", rules_.maxUlp, "Fail on a t that is further from the exact one, in float32 units")
      .takes("U")
      .notNegative();
  devices_.declare(command);
  addCommonOptions(command, common_);
}

/// The environment is asked here: CLI11 would take what it says for an argument of every command.
Expected<std::uint64_t> HardRays::readSeed() const {
  const char *const text = std::getenv("VOXC_SEED");
  if (seed_ || !text || !*text)
    return seed_.value_or(1);
  std::uint64_t seed = 0;
  const std::string_view digits = text;
  const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
  if (failure != std::errc() || end != digits.data() + digits.size() || seed > std::uint64_t{1} << 62)
    return Error::usage("VOXC_SEED is '" + std::string(digits) + "'; a seed is a number from 0 to 2^62");
  return seed;
}

Expected<HardRayBudget> HardRays::readBudget() const {
  if (budget_.empty())
    return HardRayBudget::builtin();
  auto text = VOXC_TRY(readTextFile(budget_));
  return HardRayBudget::parse(text, budget_);
}

Expected<void> HardRays::sweep(HardRaySweep &sweep) const {
  if (corpus_.empty())
    return sweep.run(size_);
  const auto text = VOXC_TRY(readTextFile(corpus_));
  const auto corpus = VOXC_TRY(parseCorpus(text, corpus_));
  return sweep.runCorpus(corpus);
}

void HardRays::addFigures(const HardRaySweep &sweep, const HardRayReport &report, Json &figures) const {
  figures["seed"] = size_.seed;
  const SweepTimes &times = sweep.times();
  figures["oracle_seconds"] = times.oracle;
  figures["oracle_mrays_per_s"] =
      times.oracle > 0 ? static_cast<double>(times.exactRays) / times.oracle * 1e-6 : 0;
  figures["build_seconds"] = times.build;
  figures["kernel_seconds"] = times.kernel;
  figures["cpu_seconds"] = times.trace;
  report.addTo(figures);
}

void printClasses() {
  for (const test::HardRayClass &row : test::hardRayClasses())
    std::printf("%-14s %s\n", std::string(row.name).c_str(), std::string(row.summary).c_str());
}

Expected<void> HardRays::run() {
  if (list_) {
    printClasses();
    return {};
  }
  const Stopwatch watch;
  size_.seed = VOXC_TRY(readSeed());
  auto budget = VOXC_TRY(readBudget());
  auto formats = VOXC_TRY(formats_.read(size_.seed));
  VOXC_TRY(devices_.open(common_));
  Json figures{{"formats", formats.size()}};
  if (tellsOnStdout(common_))
    std::printf("%zu formats, seed %llu\n", formats.size(), static_cast<unsigned long long>(size_.seed));

  HardRayReport report(rules_);
  ProgressBar bar(common_.quiet);
  HardRaySweep work(std::move(formats), scenes_, budget, devices_, report, bar.progress());
  Expected<void> swept = sweep(work);
  heedInterrupt();
  bar.clear();
  // What was found before an interrupt or an error is told all the same.
  if (tellsOnStdout(common_) && report.rays() > 0)
    report.print();
  figures["seconds"] = watch.seconds();
  addFigures(work, report, figures);
  VOXC_TRY(writeStatistics(common_.stats, figures));
  if (!swept)
    return swept;
  std::optional<Error> verdict = report.verdict();
  if (!verdict)
    return {};
  verdict->message += "; seed " + std::to_string(size_.seed) + " makes the same again";
  return *verdict;
}

} // namespace
} // namespace voxc::tool

int main(int argc, char **argv) {
  voxc::tool::catchInterrupts();
  const voxc::tool::CommandLine command("voxc-hard-rays",
                                        "Check the kernels of many formats on rays that are hard to trace");
  voxc::tool::HardRays hardRays;
  hardRays.declare(command);
  command.footer("Examples:\n"
                 "  voxc-hard-rays --random 3 --rays 100000\n"
                 "      random formats on the rays that go wrong elsewhere");
  return voxc::tool::runTool(command, argc, argv, [&] { return hardRays.run(); });
}
