// Running passes by name, each followed by the verifier.
#include "voxc/Passes/Pass.h"

#include "voxc/Support/Stopwatch.h"

namespace voxc {
namespace {

Error unknownPass(const std::string &name) {
  std::string known;
  for (const Pass &pass : passes())
    known += (known.empty() ? "" : ", ") + std::string(pass.name);
  return Error::usage("'" + name + "' is no pass; the passes are " + known);
}

Expected<void> verifyAfter(const Pass &pass, const Format &format) {
  Diagnostics diagnostics;
  verify(format, diagnostics);
  if (!diagnostics.hasErrors())
    return {};
  return Error::input("pass " + std::string(pass.name) +
                      " left a wrong format: " + diagnostics.all().front().message);
}

/// What a pass found wrong, at its places in the text that the format was written in.
Error errorAt(const Format &format, const Diagnostics &diagnostics) {
  if (format.source)
    return toError(diagnostics, format.source->text, format.source->name);
  return toError(diagnostics, toString(format), "format");
}

} // namespace

Expected<void> runPasses(Format &format, std::span<const std::string> names, const PipelineOptions &options) {
  for (const std::string &name : names) {
    const Pass *pass = findPass(name);
    if (!pass)
      return unknownPass(name);
    Diagnostics diagnostics;
    const Stopwatch watch;
    const PassResult result = pass->run(format, diagnostics);
    const double seconds = watch.seconds();
    if (diagnostics.hasErrors())
      return errorAt(format, diagnostics);
    if (options.afterEach)
      options.afterEach(*pass, format, result, seconds);
    if (options.verifyEach)
      if (auto verified = verifyAfter(*pass, format); !verified)
        return verified.error();
  }
  return {};
}

} // namespace voxc
