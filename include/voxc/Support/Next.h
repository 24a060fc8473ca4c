// What a stream gives next: a value, its end, or the error that stopped it before its end.
#pragma once

#include "voxc/Support/Error.h"

#include <utility>
#include <variant>

namespace voxc {

/// The end of a stream: all of it was given.
struct End {};

/// What comes next in a stream. The end and a stop before the end are states of their own, and none of them
/// converts to bool: `while (auto next = stream.next())` does not compile, so that no loop can take a stop
/// for the end. A loop reads
///
///     for (auto next = stream.next(); !next.isEnd(); next = stream.next()) {
///       if (next.failed())
///         return next.error();
///       use(*next);
///     }
template <typename Value> class [[nodiscard]] Next {
public:
  Next(Value value) : state_(std::in_place_index<0>, std::move(value)) {}
  Next(End) : state_(std::in_place_index<1>) {}
  Next(Error error) : state_(std::in_place_index<2>, std::move(error)) {}

  bool isEnd() const { return state_.index() == 1; }
  bool failed() const { return state_.index() == 2; }

  /// The value; neither `isEnd` nor `failed`.
  const Value &operator*() const { return std::get<0>(state_); }
  const Value *operator->() const { return &std::get<0>(state_); }
  /// Why the stream stopped; `failed`.
  const Error &error() const { return std::get<2>(state_); }

private:
  std::variant<Value, End, Error> state_;
};

} // namespace voxc
