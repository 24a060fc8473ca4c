// Errors of Windows as an `errno`.
#pragma once

namespace voxc::platform {

/// Sets `errno` by the last error of this thread; returns false, as what failed does.
bool failed();

/// The same for a result that says by false whether it failed.
inline bool succeeded(int result) { return result != 0 || failed(); }

} // namespace voxc::platform
