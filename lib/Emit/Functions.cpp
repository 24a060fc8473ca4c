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
  auto module = VOXC_TRY(glsl::parse(declared));
  auto further = VOXC_TRY(glsl::parse(functions));
  for (glsl::Declaration &declaration : module.declarations)
    declaration.isElsewhere = true;
  std::ranges::move(further.declarations, std::back_inserter(module.declarations));
  VOXC_TRY(glsl::verify(module));
  const HeaderLanguageKind &kind = kindOf(language);
  if (kind.makeReady)
    kind.makeReady(module);
  return kind.printer("")->print(module);
}

} // namespace voxc
