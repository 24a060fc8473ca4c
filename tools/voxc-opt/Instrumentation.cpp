// Printing, timing, stopping and bisecting a pipeline.
#include "Instrumentation.h"

#include "common/Files.h"
#include "common/Json.h"

#include <algorithm>
#include <cstdio>

namespace voxc::tool {
namespace {

bool contains(const std::vector<std::string> &names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

void print(const char *when, std::string_view pass, const char *note, const std::string &text) {
  std::fprintf(stderr, "-- %s %s%s\n%s", when, std::string(pass).c_str(), note, text.c_str());
}

std::string_view kindOf(const PassReport &report) { return report.changed ? "applied" : "missed"; }

std::string messageOf(const PassReport &report) {
  const std::size_t count = report.changedParts.size();
  if (!report.changed)
    return "changes nothing" + (report.why.empty() ? "" : ": " + report.why);
  if (count == 0)
    return "changes the format as a whole";
  return "changes " + std::to_string(count) + (count == 1 ? " level" : " levels");
}

} // namespace

void InstrumentationOptions::declare(const CommandLine &command) {
  command.add("--print-before", printBefore, "Print the IR to standard error before these passes")
      .list()
      .takes("A,B");
  command.add("--print-after", printAfter, "Print it after these").list().takes("A,B");
  command.addFlag("--print-before-all", printBeforeAll, "Print it before each pass");
  command.addFlag("--print-after-all", printAfterAll, "Print it after each pass");
  command.addFlag("--print-changed", printChanged, "Print it after each pass that changes it");
  command.add("--stop-before", stopBefore, "Stop before this pass, of either IR, or before lower")
      .takes("PASS");
  command.add("--stop-after", stopAfter, "Stop after this pass").takes("PASS");
  command.add("--bisect-limit", bisectLimit, "Run the first N passes alone, and print the number of each")
      .takes("N");
  command
      .add("--remarks", remarks, "Print what each pass changes (applied), or why it changes nothing (missed)")
      .list()
      .oneOf({"applied", "missed"})
      .takes("KINDS");
  command.add("--remarks-file", remarksFile, "Write the remarks to this file, as JSON").takes("FILE");
  command.addFlag("--pass-statistics", statistics, "Print how many levels each pass changes");
  command.addFlag("--time-passes", timePasses, "Print each pass's time to standard error");
}

Expected<void> Instrumentation::check(const std::vector<std::string_view> &passes) const {
  std::vector<std::string> names = options_.printBefore;
  names.insert(names.end(), options_.printAfter.begin(), options_.printAfter.end());
  names.push_back(options_.stopBefore);
  names.push_back(options_.stopAfter);
  for (const std::string &name : names)
    if (!name.empty() && std::ranges::find(passes, name) == passes.end())
      return Error::usage("there is no pass '" + name + "' in this pipeline; give one of those that run");
  return {};
}

void Instrumentation::beginInput(const SourceText &source, SourceRange begin,
                                 std::vector<Diagnostic> *remarks) {
  hasStopped_ = false;
  source_ = &source;
  begin_ = begin;
  found_ = remarks;
}

PipelineOptions Instrumentation::hooks() {
  return {.beforeEach = [this](std::string_view pass, PrintedIr ir) { return begin(pass, ir); },
          .afterEach = [this](const PassReport &report, PrintedIr ir) { end(report, ir); }};
}

bool Instrumentation::begin(std::string_view pass, PrintedIr ir) {
  hasStopped_ = hasStopped_ || pass == options_.stopBefore;
  if (hasStopped_)
    return false;
  ++begun_;
  const bool runs = begun_ <= options_.bisectLimit;
  if (options_.bisectLimit != kNoLimit)
    std::fprintf(stderr, "bisect: %s pass (%u) %s\n", runs ? "running" : "not running", begun_,
                 std::string(pass).c_str());
  if (runs && (options_.printBeforeAll || contains(options_.printBefore, pass)))
    print("before", pass, "", ir());
  return runs;
}

void Instrumentation::end(const PassReport &report, PrintedIr ir) {
  hasStopped_ = hasStopped_ || report.pass == options_.stopAfter;
  reports_.push_back(report);
  if (contains(options_.remarks, kindOf(report)))
    remark(report);
  const bool isAsked = contains(options_.printAfter, report.pass);
  if (options_.printAfterAll || isAsked || (options_.printChanged && report.changed))
    print("after", report.pass, report.changed ? "" : " (unchanged)", report.changed || isAsked ? ir() : "");
}

/// At once, as a later pass may end in an error.
void Instrumentation::remark(const PassReport &report) {
  const std::vector<SourceRange> &parts = report.changedParts;
  const bool hasPlace = !parts.empty() && parts.front() != SourceRange{};
  const Diagnostic remark{Severity::Remark, hasPlace ? parts.front() : begin_,
                          std::string(report.pass) + " " + messageOf(report)};
  remarks_.push_back(
      {kindOf(report), report.pass, messageOf(report), source_->name, lineOf(*source_, remark.range.begin)});
  if (found_)
    found_->push_back(remark);
  else if (options_.remarksFile.empty())
    std::fputs(render(remark, *source_).c_str(), stderr);
}

Expected<void> Instrumentation::finish() const {
  for (const PassReport &report : reports_) {
    const std::string pass(report.pass);
    if (options_.statistics)
      std::fprintf(stderr, "%6zu levels  %s\n", report.changedParts.size(), pass.c_str());
    if (options_.timePasses)
      std::fprintf(stderr, "%10.6f s  %s\n", report.seconds, pass.c_str());
  }
  if (options_.remarksFile.empty())
    return {};
  Json list = Json::array();
  for (const Remark &remark : remarks_)
    list.push_back({{"kind", remark.kind},
                    {"pass", remark.pass},
                    {"message", remark.message},
                    {"file", remark.file},
                    {"line", remark.line}});
  return writeText(options_.remarksFile, list.dump(2) + "\n");
}

} // namespace voxc::tool
