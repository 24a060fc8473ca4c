// What `voxc bench` does with results: commands of its own.
#pragma once

#include "program/Subcommand.h"

#include <memory>

namespace voxc::tool {

std::unique_ptr<Subcommand> makeBenchExportCommand();
std::unique_ptr<Subcommand> makeBenchImportCommand();
std::unique_ptr<Subcommand> makeBenchReportCommand();

} // namespace voxc::tool
