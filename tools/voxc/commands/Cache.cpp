// voxc cache: what is kept of kernels and construction code that were compiled before.
#include "common/Json.h"
#include "common/Statistics.h"
#include "options/Figures.h"
#include "program/Subcommand.h"
#include "voxc/Support/UserCache.h"

#include <cstdio>

namespace voxc::tool {

namespace {

class CacheCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override {
    command.addFlag("--clear", clear_, "Removes all that is kept");
    addCommonOptions(command, common_);
  }

  Expected<void> run() override {
    const std::string folder = compileCacheFolder();
    if (folder.empty()) {
      if (tellsOnStdout(common_))
        std::printf("there is no cache: VOXC_CACHE is off, or there is no home folder\n");
      return writeStatistics(common_.stats,
                             {{"folder", ""}, {"entries", 0}, {"bytes", 0}, {"most_bytes", 0}});
    }
    const auto cache = VOXC_TRY(CompileCache::open(folder));
    if (clear_)
      VOXC_TRY(cache.clear());
    const CompileCache::Usage usage = cache.usage();
    constexpr double kMiB = 1 << 20;
    if (tellsOnStdout(common_))
      std::printf("%s: %llu entries, %.1f of at most %.0f MiB\n", folder.c_str(),
                  static_cast<unsigned long long>(usage.entries), double(usage.bytes) / kMiB,
                  double(cache.mostBytes()) / kMiB);
    return writeStatistics(common_.stats, {{"folder", folder},
                                           {"entries", usage.entries},
                                           {"bytes", usage.bytes},
                                           {"most_bytes", cache.mostBytes()}});
  }

private:
  bool clear_ = false;
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeCacheCommand() { return std::make_unique<CacheCommand>(); }

} // namespace voxc::tool
