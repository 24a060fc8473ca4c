// An input as a caller in C asks for it.
#pragma once

#include "C/Handles.h"
#include "voxc/Input/Arguments.h"

#include <voxc-c/voxc.h>

#include <set>
#include <string>
#include <vector>

namespace voxc::c {

/// What was asked for, checked as a command line would be.
class CallersInput {
public:
  /// Error: `Usage`, naming an option as the command line does.
  static Expected<CallersInput> of(const char *input, const voxc_input_options &options);

  const std::string &name() const { return name_; }
  InputArguments &arguments() { return arguments_; }

  /// Opens it, for a format of that extent. Warnings and notes go to the caller's functions, each once.
  /// Errors: as `openInput`.
  Expected<Input> open(Int3 formatExtent, unsigned threads, const std::shared_ptr<WorkingMemory> &memory,
                       const Progress &progress);
  /// Tells one more warning.
  void warn(const std::string &sentence) { tell({sentence}, report_.warning); }

private:
  void tell(const std::vector<std::string> &sentences, void (*function)(void *user, const char *sentence));

  std::string name_;
  InputArguments arguments_;
  voxc_input_report report_{};
  std::set<std::string> told_;
};

} // namespace voxc::c
