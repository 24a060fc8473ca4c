// Whose messages they are.
#pragma once

namespace voxc::tool {

/// The program's name, which begins its messages: "voxc" until another one is set. May be asked by a handler
/// of signals.
const char *signature();

/// Sets it, once, before anything runs. At most 31 letters are kept.
void signAs(const char *program);

} // namespace voxc::tool
