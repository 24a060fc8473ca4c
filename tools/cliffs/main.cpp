// voxc-cliffs: draws situations at random and finds those in which rays cost far more than they should.
#include "Cases.h"
#include "Finder.h"
#include "Report.h"

#include "common/Command.h"
#include "common/CommandLine.h"
#include "voxc/Support/File.h"
#include "voxc/Support/Stopwatch.h"

#include <cstdio>

namespace voxc::cliffs {
namespace {

struct Options {
  FinderOptions finder;
  std::vector<std::string> devices;
  std::optional<std::uint64_t> situation;
  std::uint64_t first = 0, number = 0;
  double seconds = 0;
  std::size_t worst = 30;
  std::string peers, json, cases;
  bool printsCases = false;
  bool printsAll = false;
};

void declare(const tool::CommandLine &command, Options &options) {
  command.add("--seed", options.finder.seed, "Another number makes other situations")
      .takes("N")
      .showsDefault();
  command.add("--situation", options.situation, "Look at this one alone, as a report has its number")
      .takes("N");
  command.add("--first", options.first, "The situation to begin with").takes("N");
  command.add("--situations", options.number, "Look at so many").takes("N");
  command.add("--seconds", options.seconds, "Look at more until so much time has passed")
      .takes("S")
      .positive();
  command.add("--device", options.devices, "Trace on this device; may be given several times; default: cpu")
      .takes("NAME")
      .repeated();
  command.add("--most-rays", options.finder.limits.mostRays, "No situation has more rays")
      .takes("N")
      .showsDefault();
  command
      .add("--peers", options.peers,
           "A folder with a tracer in t_own.cpp, which traces the same rays on the cpu")
      .takes("DIR");
  command.add("--json", options.json, "Write each finding as a line of JSON").takes("FILE");
  command.add("--worst", options.worst, "How many of the worst are printed").takes("N").showsDefault();
  command.addFlag("--all", options.printsAll, "Print every finding as it comes");
  command.addFlag("--counts", options.printsCases, "Time nothing, and print the counts as cases");
  command
      .add("--cases", options.cases,
           "Time nothing, and fail if a case of this file has more counts than it says")
      .takes("FILE");
}

class Run {
public:
  explicit Run(const Options &options) : options_(options) {}

  Expected<void> run();

private:
  Expected<Finder> makeFinder() const;
  Expected<void> look(Finder &finder, std::uint64_t number);
  Expected<void> compareCases(Finder &finder);
  bool isOver(std::uint64_t looked) const;

  const Options &options_;
  Stopwatch watch_;
  std::vector<Finding> findings_;
  std::FILE *json_ = nullptr;
  std::uint64_t wrong_ = 0;
};

Expected<Finder> Run::makeFinder() const {
  std::vector<Machine> machines;
  for (const std::string &name :
       options_.devices.empty() ? std::vector<std::string>{"cpu"} : options_.devices) {
    auto machine = VOXC_TRY(Machine::open(name));
    machines.push_back(std::move(machine));
  }
  std::optional<Peer> peer;
  if (!options_.peers.empty()) {
    auto built = VOXC_TRY(Peer::build(options_.peers));
    peer.emplace(std::move(built));
  }
  FinderOptions finder = options_.finder;
  finder.countsAlone = options_.printsCases || !options_.cases.empty();
  return Finder::create(std::move(machines), finder, std::move(peer));
}

bool Run::isOver(std::uint64_t looked) const {
  return options_.seconds > 0 ? watch_.seconds() >= options_.seconds
                              : looked >= (options_.number > 0 ? options_.number : 100);
}

Expected<void> Run::look(Finder &finder, std::uint64_t number) {
  auto found = finder.find(number);
  if (!found)
    return Error{found.error().kind, "situation " + std::to_string(number) + ": " + found.error().message};
  for (Finding &finding : *found) {
    wrong_ += finding.wrong;
    if (options_.printsCases)
      std::printf("%s\n", caseLine(finding).c_str());
    else if (options_.printsAll)
      printFinding(finding);
    if (json_) {
      std::fprintf(json_, "%s\n", toJson(finding).dump().c_str());
      std::fflush(json_);
    }
    findings_.push_back(std::move(finding));
  }
  return {};
}

Expected<void> Run::compareCases(Finder &finder) {
  const auto text = VOXC_TRY(readTextFile(options_.cases));
  const auto cases = VOXC_TRY(parseCases(text, options_.cases));
  std::size_t bad = 0;
  for (const KeptCase &kept : cases) {
    auto found = VOXC_TRY(finder.find(kept.number));
    for (const Finding &finding : found) {
      const std::string problem = finding.machine == kept.machine ? worsened(kept, finding) : "";
      wrong_ += finding.wrong;
      bad += !problem.empty();
      if (!problem.empty())
        std::printf("situation %llu on %s: %s\n", static_cast<unsigned long long>(kept.number),
                    kept.machine.c_str(), problem.c_str());
    }
  }
  std::printf("%zu cases, %zu worse, %llu rays wrong\n", cases.size(), bad,
              static_cast<unsigned long long>(wrong_));
  return bad > 0 ? Expected<void>(Error::input("there are cases that cost more than they did"))
                 : Expected<void>();
}

Expected<void> Run::run() {
  auto finder = VOXC_TRY(makeFinder());
  if (!options_.cases.empty()) {
    VOXC_TRY(compareCases(finder));
  } else {
    if (!options_.json.empty())
      json_ = std::fopen(options_.json.c_str(), "w");
    if (!options_.json.empty() && !json_)
      return Error::environment("'" + options_.json + "' cannot be written");
    if (!options_.printsCases)
      for (const Calibration &calibration : finder.calibrations())
        std::printf("times of the model by %.2f, and %.0f ns a call\n", calibration.scale,
                    calibration.perCall);
    if (options_.printsAll)
      printHead();
    Expected<void> looked;
    if (options_.situation)
      looked = look(finder, *options_.situation);
    for (std::uint64_t i = 0; !options_.situation && looked && !isOver(i); ++i)
      looked = look(finder, options_.first + i);
    if (json_)
      std::fclose(json_);
    if (!options_.printsCases)
      printReport(findings_, options_.worst);
    if (!looked)
      return looked;
  }
  if (wrong_ > 0)
    return Error::input(std::to_string(wrong_) + " rays are not right");
  return {};
}

} // namespace
} // namespace voxc::cliffs

int main(int argc, char **argv) {
  const voxc::tool::CommandLine command(
      "voxc-cliffs",
      "Draws situations at random, and finds those in which rays cost far more than they should.");
  voxc::cliffs::Options options;
  voxc::cliffs::declare(command, options);
  return voxc::tool::runTool(command, argc, argv, [&] { return voxc::cliffs::Run(options).run(); });
}
