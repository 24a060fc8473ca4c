// CLI11 by name alone. Its header takes longer to compile than most of our files, so those files include it
// that declare options, and no header but Help.h.
#pragma once

namespace CLI {
class App;
class Option;
class Validator;
} // namespace CLI
