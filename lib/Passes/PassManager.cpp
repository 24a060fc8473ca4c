// Running passes by name, each followed by the verifier.
#include "voxc/Passes/Pass.h"

#include "voxc/Support/Stopwatch.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace voxc {
namespace {

/// A pass as it was written: alone, or with its number behind a '='.
struct Call {
  const Pass *pass;
  std::optional<int> number;
};

Error unknownPass(const std::string &name) {
  std::string known;
  for (const Pass &pass : passes())
    known += (known.empty() ? "" : ", ") + std::string(pass.name);
  return Error::usage("'" + name + "' is no pass; the passes are " + known);
}

Expected<Call> readCall(const std::string &written) {
  const Pass *const pass = findPass(written);
  if (!pass)
    return unknownPass(written);
  Call call{pass, {}};
  if (written.size() == pass->name.size())
    return call;
  const std::string text = written.substr(pass->name.size() + 1);
  if (!pass->number)
    return Error::usage("pass '" + std::string(pass->name) + "' takes no number, found '" + text + "'");
  int number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size() || number < pass->number->least ||
      number > pass->number->most)
    return Error::usage("pass '" + std::string(pass->name) + "' takes a number from " +
                        std::to_string(pass->number->least) + " to " + std::to_string(pass->number->most) +
                        ", not '" + text + "'");
  call.number = number;
  return call;
}

/// Rewrites as they are written, then choices as the table has them, and their numbers.
void resolveOrder(std::vector<Call> &calls) {
  const auto rankOf = [](const Call &call) {
    return call.pass->rewrites ? std::pair<std::ptrdiff_t, int>(-1, 0)
                               : std::pair(call.pass - passes().data(), call.number.value_or(0));
  };
  std::ranges::stable_sort(calls, {}, rankOf);
  // A choice that is made twice is one; granules count how often they are asked for.
  const auto repeated = std::ranges::unique(calls, [](const Call &a, const Call &b) {
    return a.pass == b.pass && a.number == b.number && a.pass->choice.kind;
  });
  calls.erase(repeated.begin(), repeated.end());
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

Expected<void> runCall(const Call &call, Format &format, const PipelineOptions &options) {
  if (options.beforeEach && !options.beforeEach(*call.pass, format))
    return {};
  const Format before = format;
  Diagnostics diagnostics;
  const Stopwatch watch;
  const PassResult result = call.pass->run(format, diagnostics, call.number);
  const double seconds = watch.seconds();
  if (diagnostics.hasErrors())
    return errorAt(format, diagnostics);
  const std::string why = diagnostics.all().empty() ? "" : diagnostics.all().front().message;
  if (options.afterEach)
    options.afterEach({*call.pass, before, format, result, seconds, why});
  return options.verifyEach ? verifyAfter(*call.pass, format) : Expected<void>();
}

} // namespace

Expected<void> runPasses(Format &format, std::span<const std::string> names, const PipelineOptions &options) {
  std::vector<Call> calls;
  for (const std::string &name : names) {
    auto call = readCall(name);
    if (!call)
      return call.error();
    calls.push_back(*call);
  }
  if (options.order == PassOrder::Resolved)
    resolveOrder(calls);
  for (const Call &call : calls)
    if (auto done = runCall(call, format, options); !done)
      return done;
  return {};
}

} // namespace voxc
