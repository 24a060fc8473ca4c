// Running passes by name, each followed by the verifier.
#include "voxc/Passes/Pass.h"

#include "voxc/Support/Stopwatch.h"

#include <charconv>

namespace voxc {
namespace {

Error unknownPass(const std::string &name) {
  std::string known;
  for (const Pass &pass : passes())
    known += (known.empty() ? "" : ", ") + std::string(pass.name);
  return Error::usage("'" + name + "' is no pass; the passes are " + known);
}

/// Runs a pass as it was written: alone, or with its number behind a '='.
Expected<PassResult> run(const Pass &pass, std::string_view written, Format &format,
                         Diagnostics &diagnostics) {
  if (written.size() == pass.name.size())
    return pass.run(format, diagnostics);
  const std::string_view text = written.substr(pass.name.size() + 1);
  if (!pass.number)
    return Error::usage("pass '" + std::string(pass.name) + "' takes no number, found '" + std::string(text) +
                        "'");
  int number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size() || number < pass.number->least ||
      number > pass.number->most)
    return Error::usage("pass '" + std::string(pass.name) + "' takes a number from " +
                        std::to_string(pass.number->least) + " to " + std::to_string(pass.number->most) +
                        ", not '" + std::string(text) + "'");
  return pass.number->run(format, number, diagnostics);
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
    const Expected<PassResult> result = run(*pass, name, format, diagnostics);
    const double seconds = watch.seconds();
    if (!result)
      return result.error();
    if (diagnostics.hasErrors())
      return errorAt(format, diagnostics);
    if (options.afterEach)
      options.afterEach(*pass, format, *result, seconds);
    if (options.verifyEach)
      if (auto verified = verifyAfter(*pass, format); !verified)
        return verified.error();
  }
  return {};
}

} // namespace voxc
