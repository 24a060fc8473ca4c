// voxc doctor: whether this machine has what voxc needs, and how to mend what it lacks.
#include "common/Json.h"
#include "common/Statistics.h"
#include "doctor/Checks.h"
#include "options/Figures.h"
#include "program/Subcommand.h"

#include <algorithm>
#include <cstdio>

namespace voxc::tool {

namespace {

void print(const Check &check) {
  std::printf("%-4s  %s: %s\n", std::string(wordOf(check.state)).c_str(), check.subject.c_str(),
              check.found.c_str());
  if (!check.remedy.empty())
    std::printf("      %s\n", check.remedy.c_str());
}

Json describe(const Check &check) {
  Json figures{
      {"subject", check.subject}, {"state", std::string(wordOf(check.state))}, {"found", check.found}};
  if (!check.remedy.empty())
    figures["remedy"] = check.remedy;
  return figures;
}

class DoctorCommand final : public Subcommand {
public:
  void declare(const CommandLine &command) override { addCommonOptions(command, common_); }

  Expected<void> run() override {
    Json figures{{"checks", Json::array()}};
    std::size_t bad = 0;
    for (const auto look : {checkBuild, checkProcessor, checkDevices, checkFolders, checkPrograms})
      for (const Check &check : look()) {
        bad += check.state == Check::State::Bad ? 1 : 0;
        figures["checks"].push_back(describe(check));
        if (tellsOnStdout(common_))
          print(check);
      }
    figures["usable"] = bad == 0;
    if (tellsOnStdout(common_) && bad == 0)
      std::puts("voxc can be used here");
    if (Expected<void> written = writeStatistics(common_.stats, figures); !written || bad == 0)
      return written;
    return Error::environment("voxc cannot be used here before what is bad above is mended");
  }

private:
  CommonOptions common_;
};

} // namespace

std::unique_ptr<Subcommand> makeDoctorCommand() { return std::make_unique<DoctorCommand>(); }

} // namespace voxc::tool
