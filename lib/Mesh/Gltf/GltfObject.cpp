// Typed access to the members of JSON objects.
#include "Mesh/Gltf/GltfObject.h"

namespace voxc {

namespace {

/// `value` as an index below `size`; if it is none, the problem names it.
std::optional<std::size_t> checkedIndex(Json value, const std::string &name, const GltfList &list,
                                        Problem &problem) {
  const auto index = value.count();
  if (index && *index < list.size())
    return static_cast<std::size_t>(*index);
  if (index)
    problem.set(name + " is " + std::to_string(*index) + ", but there are " + std::to_string(list.size()) +
                " " + list.name());
  else
    problem.set(name + " is not an index of " + list.name());
  return std::nullopt;
}

} // namespace

GltfObject::GltfObject(Json json, std::string name, Problem &problem)
    : json_(json), name_(std::move(name)), problem_(&problem) {
  if (json_ && !json_.isObject()) {
    problem_->set((name_.empty() ? "its JSON" : name_) + " is not an object");
    json_ = {};
  }
}

std::set<std::string, std::less<>> GltfObject::extensionNames() const {
  std::set<std::string, std::less<>> names;
  // A list of what is still to do: a file may nest its values as deep as it likes.
  std::vector<Json> pending{json_};
  while (!pending.empty()) {
    const Json next = pending.back();
    pending.pop_back();
    for (std::size_t i = 0; i < next.size(); ++i)
      pending.push_back(next[i]);
    for (const std::string_view key : next.keys()) {
      if (key == "extras")
        continue;
      pending.push_back(next[key]);
      if (key == "extensions")
        for (const std::string_view name : next[key].keys())
          names.emplace(name);
    }
  }
  return names;
}

std::string GltfObject::nameOf(std::string_view key) const {
  return name_.empty() ? std::string(key) : name_ + "." + std::string(key);
}

void GltfObject::wrongType(std::string_view key, const char *right) const {
  problem_->set(nameOf(key) + " is not " + right);
}

std::optional<std::uint64_t> GltfObject::count(std::string_view key) const {
  const Json value = json_[key];
  const auto count = value.count();
  if (value && !count)
    wrongType(key, "a whole number");
  return count;
}

std::optional<std::size_t> GltfObject::index(std::string_view key, const GltfList &list) const {
  const Json value = json_[key];
  if (!value)
    return std::nullopt;
  return checkedIndex(value, nameOf(key), list, *problem_);
}

double GltfObject::number(std::string_view key, double standard) const {
  const Json value = json_[key];
  const auto number = value.number();
  if (value && !number)
    wrongType(key, "a number");
  return number.value_or(standard);
}

bool GltfObject::flag(std::string_view key) const {
  const Json value = json_[key];
  const auto flag = value.flag();
  if (value && !flag)
    wrongType(key, "true or false");
  return flag.value_or(false);
}

std::string_view GltfObject::text(std::string_view key) const {
  const Json value = json_[key];
  const auto text = value.text();
  if (value && !text)
    wrongType(key, "a string");
  return text.value_or(std::string_view());
}

void GltfObject::readNumbers(std::string_view key, double *numbers, std::size_t count) const {
  const Json value = json_[key];
  if (!value)
    return;
  bool isRight = value.size() == count;
  for (std::size_t i = 0; isRight && i < count; ++i) {
    const auto number = value[i].number();
    isRight = number.has_value();
    numbers[i] = number.value_or(0);
  }
  if (!isRight)
    wrongType(key, ("an array of " + std::to_string(count) + " numbers").c_str());
}

GltfObject GltfObject::object(std::string_view key) const { return {json_[key], nameOf(key), *problem_}; }

GltfList GltfObject::list(std::string_view key) const { return {json_[key], nameOf(key), *problem_}; }

GltfList::GltfList(Json json, std::string name, Problem &problem)
    : json_(json), name_(std::move(name)), problem_(&problem) {
  if (json_ && !json_.isArray()) {
    problem_->set(name_ + " is not an array");
    json_ = {};
  }
}

GltfObject GltfList::operator[](std::size_t index) const {
  return {json_[index], name_ + "[" + std::to_string(index) + "]", *problem_};
}

std::optional<std::size_t> GltfList::index(std::size_t element, const GltfList &list) const {
  return checkedIndex(json_[element], name_ + "[" + std::to_string(element) + "]", list, *problem_);
}

double GltfList::number(std::size_t element) const {
  const auto number = json_[element].number();
  if (!number)
    problem_->set(name_ + "[" + std::to_string(element) + "] is not a number");
  return number.value_or(0);
}

std::string_view GltfList::text(std::size_t element) const {
  const auto text = json_[element].text();
  if (!text)
    problem_->set(name_ + "[" + std::to_string(element) + "] is not a string");
  return text.value_or(std::string_view());
}

} // namespace voxc
