// Functions of GLSL in other languages.
#include "HeaderLanguages.h"

#include "Glsl/Parse.h"
#include "Glsl/Verify.h"

#include "voxc/Emit/Emit.h"

#include <algorithm>
#include <iterator>

namespace voxc {

Expected<std::string> emitFunctions(std::string_view functions, std::string_view declared,
                                    HeaderLanguage language) {
  auto module = glsl::parse(declared);
  if (!module)
    return module.error();
  auto further = glsl::parse(functions);
  if (!further)
    return further.error();
  for (glsl::Declaration &declaration : module->declarations)
    declaration.isElsewhere = true;
  std::ranges::move(further->declarations, std::back_inserter(module->declarations));
  if (const auto verified = glsl::verify(*module); !verified)
    return verified.error();
  const HeaderLanguageKind &kind = kindOf(language);
  if (kind.makeReady)
    kind.makeReady(*module);
  return kind.printer("")->print(*module);
}

} // namespace voxc
