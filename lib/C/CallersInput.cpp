// Inputs of callers in C.
#include "C/CallersInput.h"

#include "voxc/Components/Components.h"

namespace voxc::c {
namespace {

/// So many numbers; none of null.
std::vector<double> numbersOf(const double *numbers, std::size_t count) {
  return numbers ? std::vector<double>(numbers, numbers + count) : std::vector<double>();
}

/// As a command line would have them.
InputArguments argumentsOf(const voxc_input_options &read) {
  InputArguments arguments;
  arguments.resolution = read.resolution;
  arguments.voxelSize = textOr(read.voxel_size, "");
  arguments.unit = textOr(read.unit, "");
  arguments.align = numbersOf(read.align, 3);
  arguments.bounds = numbersOf(read.bounds, 6);
  arguments.up = read.z_up > 0 ? "z" : read.z_up < 0 ? "y" : "";
  arguments.coverage = textOr(read.coverage, "");
  arguments.colour = textOr(read.colour, "");
  if (read.threshold)
    arguments.threshold = *read.threshold;
  arguments.colourMap = textOr(read.colour_map, "");
  arguments.window = numbersOf(read.window, 2);
  arguments.volume = read.volume;
  arguments.grid = textOr(read.grid, "");
  arguments.interior = textOr(read.interior, "");
  arguments.fillColour = textOr(read.fill_colour, "");
  arguments.crop = read.crop != 0;
  return arguments;
}

} // namespace

Expected<CallersInput> CallersInput::of(const char *input, const voxc_input_options &options) {
  CallersInput asked;
  asked.name_ = input;
  asked.arguments_ = argumentsOf(options);
  if (options.report)
    asked.report_ = *options.report;
  VOXC_TRY(checkInputValues(asked.arguments_));
  VOXC_TRY(checkInputArguments(asked.arguments_, asked.name_));
  return asked;
}

Expected<Input> CallersInput::open(Int3 formatExtent, unsigned threads,
                                   const std::shared_ptr<WorkingMemory> &memory, const Progress &progress) {
  InputOptions choices = inputOptionsOf(arguments_, formatExtent);
  choices.otherKinds = componentInputs();
  choices.threads = threads;
  choices.memory = memory;
  choices.progress = progress;
  Expected<Input> opened = openInput(name_, choices);
  if (opened) {
    tell(opened->warnings, report_.warning);
    tell(opened->notes, report_.note);
  }
  return opened;
}

void CallersInput::tell(const std::vector<std::string> &sentences,
                        void (*function)(void *user, const char *sentence)) {
  for (const std::string &sentence : sentences)
    if (function && told_.insert(sentence).second)
      function(report_.user, sentence.c_str());
}

} // namespace voxc::c
