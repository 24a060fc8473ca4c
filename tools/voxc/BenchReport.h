// voxc bench report: its options and its work, for the command `bench` to mount.
#pragma once

#include "common/Command.h"

#include <string>
#include <vector>

namespace voxc::tool {

class BenchReport {
public:
  /// Adds the command `report` to `bench`.
  void declare(CLI::App &bench);
  /// Whether the command line asks for it.
  bool isAsked() const { return app_->parsed(); }
  Expected<void> run() const;

private:
  CLI::App *app_ = nullptr;
  std::vector<std::string> folders_;
  std::string output_;
  CommonOptions common_;
};

} // namespace voxc::tool
