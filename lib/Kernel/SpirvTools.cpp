// Validation, optimisation and disassembly with SPIRV-Tools.
#include "Stages.h"

#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

namespace voxc {
namespace {

constexpr spv_target_env kEnvironment = SPV_ENV_VULKAN_1_2;

/// Collects what a tool says.
spvtools::MessageConsumer into(std::string &log) {
  return [&log](spv_message_level_t, const char *, const spv_position_t &, const char *message) {
    log += (log.empty() ? "" : "; ") + std::string(message);
  };
}

} // namespace

Expected<void> validateSpirv(const SpirvWords &module) {
  std::string log;
  spvtools::SpirvTools tools(kEnvironment);
  tools.SetMessageConsumer(into(log));
  spvtools::ValidatorOptions options;
  options.SetFriendlyNames(false); // To make names for what is right would take two thirds of the time.
  if (tools.Validate(module.data(), module.size(), options))
    return {};
  log.clear();
  tools.Validate(module.data(), module.size(), spvtools::ValidatorOptions());
  return Error::input("spirv-val rejects the kernel: " + log);
}

Expected<SpirvWords> optimiseSpirv(const SpirvWords &module) {
  std::string log;
  spvtools::Optimizer optimizer(kEnvironment);
  optimizer.SetMessageConsumer(into(log));
  optimizer.RegisterPerformancePasses();
  SpirvWords optimised;
  if (!optimizer.Run(module.data(), module.size(), &optimised))
    return Error::input("spirv-opt fails on the kernel: " + log);
  return optimised;
}

Expected<std::string> disassembleSpirv(const SpirvWords &module) {
  std::string text;
  spvtools::SpirvTools tools(kEnvironment);
  constexpr auto options = SPV_BINARY_TO_TEXT_OPTION_INDENT | SPV_BINARY_TO_TEXT_OPTION_FRIENDLY_NAMES;
  if (!tools.Disassemble(module, &text, options))
    return Error::input("spirv-dis cannot read the module");
  return text;
}

} // namespace voxc
