// voxc bench export: packs the cells of a sweep for a machine that has voxc-trace alone.
#include "sweep/BenchActions.h"
#include "sweep/Pack.h"
#include "sweep/Sweep.h"

#include "common/Statistics.h"
#include "options/Figures.h"
#include "options/Outputs.h"
#include "voxc/Measure/RecordFile.h"

#include <filesystem>
#include <set>

namespace voxc::tool {

namespace {

using namespace bench;

/// Room for the names of files and what an archive adds.
constexpr std::uint64_t kDefaultPackMegabytes = 58;

class BenchExportCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.add("DIR", folder_, "Folder of a sweep, with its cache").required().takes("");
    command.add("-o,--output", output_, "Folder for the packs, pack-001 and so on")
        .takes("PACKDIR")
        .required();
    command.add("--pack-megabytes", packMegabytes_, "Size of a pack at most, in 10^6 bytes")
        .takes("N")
        .between(1u, 1000000u)
        .showsDefault();
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    VOXC_TRY(checkFiguresNoResults(folder_, common_));
    std::error_code ignored;
    if (std::filesystem::exists(output_ + "/pack-001", ignored))
      return Error::usage("'" + output_ +
                          "' has packs of an earlier export, which would be taken for pieces of "
                          "the new ones; name another folder, or remove them");
    const auto records = VOXC_TRY(readRecords(folder_));
    VOXC_TRY(makeOutputFolder(output_));
    PackWriter packs(output_, packMegabytes_ * 1000000);
    std::uint64_t cells = 0;
    std::set<std::string> known;
    for (const Record &record : records) {
      if (!record.isMeasured() || !known.insert(withoutDevice(record)).second)
        continue;
      VOXC_TRY(packCell(record, folder_, packs));
      ++cells;
    }
    if (cells == 0)
      return Error::input("folder '" + folder_ + "' has no measured cells; 'voxc bench' makes them");
    VOXC_TRY(packs.finish());
    return tellFigures(common_, {{"cells", cells}, {"packs", packs.packs()}});
  }

private:
  /// What the cells of several devices have in common.
  static std::string withoutDevice(Record record) {
    record.device = {};
    return cellDigest(record);
  }

  std::string folder_, output_;
  std::uint64_t packMegabytes_ = kDefaultPackMegabytes;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeBenchExportCommand() { return std::make_unique<BenchExportCommand>(); }

} // namespace voxc::tool
