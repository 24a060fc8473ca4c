// JSON through nlohmann::json, whose types and exceptions stay in this file.
#include "Mesh/Gltf/Json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace voxc {

namespace {

using Value = nlohmann::json;

const Value &valueOf(const void *value) { return *static_cast<const Value *>(value); }

} // namespace

Expected<JsonDocument> JsonDocument::parse(std::span<const std::byte> text) {
  JsonDocument document;
  const auto *begin = reinterpret_cast<const char *>(text.data());
  try {
    document.value_ = std::make_shared<const Value>(Value::parse(begin, begin + text.size()));
  } catch (const Value::parse_error &error) {
    return Error::input("its JSON is malformed at byte " + std::to_string(error.byte));
  } catch (const Value::exception &) {
    return Error::input("its JSON has a number that is too large");
  }
  return document;
}

bool Json::isArray() const { return value_ && valueOf(value_).is_array(); }

bool Json::isObject() const { return value_ && valueOf(value_).is_object(); }

std::size_t Json::size() const { return isArray() ? valueOf(value_).size() : 0; }

Json Json::operator[](std::size_t index) const {
  return index < size() ? Json(&valueOf(value_)[index]) : Json();
}

Json Json::operator[](std::string_view key) const {
  if (!isObject())
    return {};
  const auto &members = valueOf(value_).get_ref<const Value::object_t &>();
  const auto found = members.find(std::string(key));
  return found == members.end() ? Json() : Json(&found->second);
}

std::vector<std::string_view> Json::keys() const {
  std::vector<std::string_view> names;
  if (isObject())
    for (const auto &[name, value] : valueOf(value_).get_ref<const Value::object_t &>())
      names.push_back(name);
  return names;
}

std::optional<double> Json::number() const {
  if (!value_ || !valueOf(value_).is_number())
    return std::nullopt;
  return valueOf(value_).get<double>();
}

std::optional<std::uint64_t> Json::count() const {
  const auto value = number();
  if (!value || !(*value >= 0 && *value <= 0x1p53) || *value != std::floor(*value))
    return std::nullopt;
  return static_cast<std::uint64_t>(*value);
}

std::optional<std::string_view> Json::text() const {
  if (!value_ || !valueOf(value_).is_string())
    return std::nullopt;
  return std::string_view(valueOf(value_).get_ref<const std::string &>());
}

std::optional<bool> Json::flag() const {
  if (!value_ || !valueOf(value_).is_boolean())
    return std::nullopt;
  return valueOf(value_).get<bool>();
}

} // namespace voxc
