// voxc bench: measurements of formats, and their report.
#include "BenchReport.h"
#include "Subcommand.h"

namespace voxc::tool {
namespace {

class BenchCommand final : public Subcommand {
public:
  void declare(CLI::App &app) override {
    report_.declare(app);
    app.require_subcommand(1);
  }
  Expected<void> run() override { return report_.run(); }

private:
  BenchReport report_;
};

} // namespace

std::unique_ptr<Subcommand> makeBenchCommand() { return std::make_unique<BenchCommand>(); }

} // namespace voxc::tool
