// A kernel's interface as JSON.
#include "building/InterfaceText.h"

#include "common/Json.h"
#include "voxc/Trace/KernelInterface.h"

#include <array>
#include <cstdio>

namespace voxc::tool {

namespace {

Json fields(const std::vector<KernelField> &fields) {
  Json list = Json::array();
  for (const KernelField &field : fields)
    list.push_back({{"name", field.name}, {"type", field.type}, {"offset", field.offset}});
  return list;
}

Json binding(const KernelBinding &binding) {
  Json json{{"binding", binding.binding},
            {"name", binding.name},
            {"type", "storage buffer"},
            {"access", binding.access}};
  if (!binding.header.empty()) {
    json["header"] = fields(binding.header);
    json["header_bytes"] = binding.headerBytes;
  }
  json["record"] = fields(binding.record);
  json["record_bytes"] = binding.recordBytes;
  return json;
}

Json constant(const KernelConstant &constant) {
  return {{"id", constant.id},
          {"name", constant.name},
          {"type", constant.type},
          {"default", Json::parse(constant.defaultValue)}};
}

template <typename Items, typename Describe> Json list(const Items &items, Describe describe) {
  Json json = Json::array();
  for (const auto &item : items)
    json.push_back(describe(item));
  return json;
}

std::string hexadecimal(std::uint64_t number) {
  std::array<char, 17> digits;
  std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(number));
  return digits.data();
}

} // namespace

Expected<std::string> interfaceText(std::string_view format, const Kernel &kernel) {
  const auto interface = VOXC_TRY(interfaceOf(kernel));
  const Json json{{"format", format},
                  {"storage_digest", hexadecimal(kernel.storageDigest)},
                  {"addressing", toString(kernel.addressing)},
                  {"loops", toString(kernel.loops)},
                  {"arithmetic", toString(kernel.arithmetic)},
                  {"entry_point", interface.entryPoint},
                  {"workgroup_size", interface.workgroupSize},
                  {"descriptor_set", interface.descriptorSet},
                  {"bindings", list(interface.bindings, binding)},
                  {"push_constants", fields(interface.pushConstants)},
                  {"push_constant_bytes", interface.pushConstantBytes},
                  {"specialization_constants", list(interface.constants, constant)},
                  {"features", interface.features}};
  return json.dump(2) + "\n";
}

} // namespace voxc::tool
