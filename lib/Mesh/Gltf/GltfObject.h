// Fields of the objects of a glTF file, each of the type that it must have.
#pragma once

#include "Mesh/Gltf/Json.h"
#include "Support/Problem.h"

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace voxc {

class GltfList;

/// An object, or nothing, with the name that messages give it, such as "accessors[3]". A field that is absent
/// has its default; one of another type is a problem.
class GltfObject {
public:
  GltfObject(Json json, std::string name, Problem &problem);

  explicit operator bool() const { return static_cast<bool>(json_); }
  const std::string &name() const { return name_; }

  /// A whole number from 0 to 2^53.
  std::optional<std::uint64_t> count(std::string_view key) const;
  /// The index of an element of the list `list`, which has `size` of them.
  std::optional<std::size_t> index(std::string_view key, const GltfList &list) const;
  double number(std::string_view key, double standard) const;
  bool flag(std::string_view key) const;
  std::string_view text(std::string_view key) const;
  /// Exactly `N` numbers.
  template <std::size_t N>
  std::array<double, N> numbers(std::string_view key, const std::array<double, N> &standard) const {
    std::array<double, N> numbers = standard;
    readNumbers(key, numbers.data(), N);
    return numbers;
  }

  /// The names of all fields.
  std::vector<std::string_view> keys() const { return json_.keys(); }
  bool has(std::string_view key) const { return static_cast<bool>(json_[key]); }
  GltfObject object(std::string_view key) const;
  /// The extension of this name that the object has, or nothing.
  GltfObject extension(std::string_view name) const { return object("extensions").object(name); }
  GltfList list(std::string_view key) const;
  /// The names of all extensions that the object has, and what is below it but for `extras`.
  std::set<std::string, std::less<>> extensionNames() const;

  /// Says that something is wrong with this object.
  void problem(const std::string &what) const { problem_->set(name_ + " " + what); }

private:
  std::string nameOf(std::string_view key) const;
  void wrongType(std::string_view key, const char *right) const;
  void readNumbers(std::string_view key, double *numbers, std::size_t count) const;

  Json json_;
  std::string name_;
  Problem *problem_;
};

/// An array of objects or numbers, or nothing.
class GltfList {
public:
  GltfList(Json json, std::string name, Problem &problem);

  std::size_t size() const { return json_.size(); }
  const std::string &name() const { return name_; }
  GltfObject operator[](std::size_t index) const;
  /// The element as an index of `list`, or nothing and a problem.
  std::optional<std::size_t> index(std::size_t element, const GltfList &list) const;
  std::string_view text(std::size_t element) const;
  double number(std::size_t element) const;

private:
  friend class GltfObject;

  Json json_;
  std::string name_;
  Problem *problem_;
};

} // namespace voxc
