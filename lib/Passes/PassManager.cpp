// Passes as they are written, and the order in which they run.
#include "voxc/IR/FormatTraits.h"
#include "voxc/Passes/Pass.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace voxc {
namespace {

/// A pass as written: alone, or with its number.
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

Error wrongCall(const Pass &pass, const std::string &problem) {
  return Error::usage("pass '" + std::string(pass.name) + "' takes " + problem);
}

/// The number in what follows a pass's name: "=4", "{bits=4}" or "{}".
Expected<std::string_view> numberText(const Pass &pass, std::string_view written) {
  if (written.starts_with('='))
    return written.substr(1);
  if (!written.ends_with('}'))
    return wrongCall(pass, "options between braces, and '" + std::string(written) + "' has no '}'");
  const std::string_view option = written.substr(1, written.size() - 2);
  const std::size_t end = std::min(option.find('='), option.size());
  if (option.empty() || (pass.number && option.substr(0, end) == pass.number->name && end < option.size()))
    return option.substr(std::min(end + 1, option.size()));
  return wrongCall(pass,
                   (pass.number ? "the option " + std::string(pass.number->name) + "=N" : "no options") +
                       ", found '" + std::string(option) + "'");
}

Expected<Call> readCall(const std::string &written) {
  const Pass *const pass = findPass(written);
  if (!pass)
    return unknownPass(written);
  if (written.size() == pass->name.size())
    return Call{pass, {}};
  const auto text = VOXC_TRY(numberText(*pass, std::string_view(written).substr(pass->name.size())));
  if (written.ends_with("{}"))
    return Call{pass, {}};
  if (!pass->number)
    return wrongCall(*pass, "no number, found '" + std::string(text) + "'");
  int number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size() || number < pass->number->least ||
      number > pass->number->most)
    return wrongCall(*pass, "a number from " + std::to_string(pass->number->least) + " to " +
                                std::to_string(pass->number->most) + ", not '" + std::string(text) + "'");
  return Call{pass, number};
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

} // namespace

Expected<std::string> passText(const std::string &name) {
  const auto call = VOXC_TRY(readCall(name));
  const Pass &pass = *call.pass;
  if (!pass.number)
    return std::string(pass.name);
  return std::string(pass.name) + "{" + std::string(pass.number->name) + "=" +
         std::to_string(call.number.value_or(pass.number->byDefault)) + "}";
}

Expected<void> runPasses(Format &format, std::span<const std::string> names, const PipelineOptions &options,
                         PassOrder order) {
  std::vector<Call> calls;
  for (const std::string &name : names) {
    auto call = VOXC_TRY(readCall(name));
    calls.push_back(call);
  }
  if (order == PassOrder::Resolved)
    resolveOrder(calls);
  PassManager<Format> manager;
  for (const Call &call : calls)
    manager.add(call.pass->name, [call](Format &ir, Diagnostics &diagnostics) {
      call.pass->run(ir, diagnostics, call.number);
    });
  return manager.run(format, options);
}

} // namespace voxc
