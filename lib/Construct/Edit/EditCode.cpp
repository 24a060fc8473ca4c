// From the plan to callable code.
#include "EditCode.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Layout/Edits.h"
#include "voxc/Support/EmbeddedFile.h"

namespace voxc {

Expected<EditCode> EditCode::compile(const Format &format, const CompileCache *cache) {
  auto plan = VOXC_TRY(makePlan(format));
  if (const std::string reason = whyNoEdits(plan.layout); !reason.empty())
    return Error::input("the format " + toString(format) + " cannot be edited: " + reason);
  const std::string text = emitEdit(plan);
  std::vector<MemoryFile> files = {{"edit.cpp", text}};
  for (const EmbeddedFile &header : constructHeaders())
    files.push_back({std::string(header.path), header.text});
  auto compiled = VOXC_TRY(JitCode::compile(files, {.optimisation = 1}, cache, toString(format)));
  EditCode code(std::move(compiled));
  auto bytes = code.code_.find("voxc_edit_bytes"), begin = code.code_.find("voxc_edit_begin"),
       edit = code.code_.find("voxc_edit");
  for (const auto *const found : {&bytes, &begin, &edit})
    if (!*found)
      return found->error();
  code.bytes_ = reinterpret_cast<Bytes>(*bytes);
  code.begin_ = reinterpret_cast<Begin>(*begin);
  code.edit_ = reinterpret_cast<Edit>(*edit);
  return code;
}

void EditCode::begin(EditHost &host) {
  run_ = std::make_unique_for_overwrite<std::byte[]>(bytes_());
  begin_(run_.get(), &host.interface(), &host.edits());
}

} // namespace voxc
