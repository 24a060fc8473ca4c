// Errors as values: voxc's libraries never print, throw across their interface, or exit.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace voxc {

/// What an error means to whoever called; the driver's exit code follows from it.
enum class ErrorKind {
  Input,       ///< The input is wrong, or a check failed (exit code 1).
  Usage,       ///< The call itself is wrong (exit code 2).
  Environment, ///< The machine lacks something: a device, disk space, a permission (exit code 3).
  Interrupted, ///< The caller asked to stop (exit code 130).
};

/// One failure: its kind and one lower-case sentence, or several lines of rendered diagnostics.
struct Error {
  ErrorKind kind = ErrorKind::Input;
  std::string message;

  static Error input(std::string message) { return {ErrorKind::Input, std::move(message)}; }
  static Error usage(std::string message) { return {ErrorKind::Usage, std::move(message)}; }
  static Error environment(std::string message) { return {ErrorKind::Environment, std::move(message)}; }
  static Error interrupted() { return {ErrorKind::Interrupted, "interrupted"}; }
};

/// A `Value`, or the `Error` that prevented it. Test before use: `if (!result) return result.error();`, which
/// `VOXC_TRY` does.
template <typename Value> class [[nodiscard]] Expected {
public:
  Expected(Value value) : state_(std::in_place_index<0>, std::move(value)) {}
  Expected(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  explicit operator bool() const { return state_.index() == 0; }
  Value &operator*() & { return std::get<0>(state_); }
  const Value &operator*() const & { return std::get<0>(state_); }
  Value &&operator*() && { return std::get<0>(std::move(state_)); }
  Value *operator->() { return &std::get<0>(state_); }
  const Value *operator->() const { return &std::get<0>(state_); }
  const Error &error() const { return std::get<1>(state_); }

private:
  std::variant<Value, Error> state_;
};

/// Success without a value, or an `Error`: `return {};` succeeds.
template <> class [[nodiscard]] Expected<void> {
public:
  Expected() = default;
  Expected(Error error) : error_(std::move(error)) {}

  explicit operator bool() const { return !error_; }
  const Error &error() const { return *error_; }

private:
  std::optional<Error> error_;
};

/// What `VOXC_TRY` takes out of a result that is no error.
template <typename Result> auto unwrap(Result &&result) {
  if constexpr (requires { *std::forward<Result>(result); })
    return *std::forward<Result>(result);
}

} // namespace voxc

/// The value of an `Expected`, or, if it has none, a return of its error from the function that this stands
/// in: `const Mesh mesh = VOXC_TRY(readMesh(path));`. To stand alone, behind `=` or behind `return`, and
/// within no larger expression, whose other values a return would leave behind. A statement expression: g++
/// and Clang have them.
#define VOXC_TRY(...)                                                                                        \
  __extension__({                                                                                            \
    auto &&voxcResult = (__VA_ARGS__);                                                                       \
    if (!voxcResult) [[unlikely]]                                                                            \
      return voxcResult.error();                                                                             \
    voxc::unwrap(std::forward<decltype(voxcResult)>(voxcResult));                                            \
  })
