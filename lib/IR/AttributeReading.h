// Readers of attributes: from the number of a value to the value.
#pragma once

#include <cstddef>

namespace voxc {

/// Of enumerations whose first values are those of the attribute, in its order.
template <typename Enum> Enum as(std::size_t value) { return static_cast<Enum>(value); }

inline int asNumber(std::size_t value) { return static_cast<int>(value); }
/// Of no and yes, and of yes and no.
inline bool isSecond(std::size_t value) { return value == 1; }
inline bool isFirst(std::size_t value) { return value == 0; }

} // namespace voxc
