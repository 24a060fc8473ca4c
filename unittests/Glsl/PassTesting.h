// Passes on texts of a few lines.
#pragma once

#include "Glsl/Parse.h"
#include "Glsl/Passes.h"
#include "Glsl/Print.h"

#include <string>
#include <string_view>

namespace voxc::glsl {

/// What `pass(module)` makes of a text; or what is wrong with the text.
template <typename Pass> std::string after(std::string_view text, const Pass &pass) {
  auto module = parse(text);
  if (!module)
    return module.error().message;
  pass(*module);
  return print(*module);
}

} // namespace voxc::glsl
