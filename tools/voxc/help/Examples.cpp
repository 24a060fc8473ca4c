// Examples of commands. test/Driver/examples.test runs them.
#include "help/Examples.h"

#include "voxc/IR/LevelKind.h"

namespace voxc::tool {

namespace {

constexpr Example kExamples[] = {
    {"compile", "voxc compile 'R(4, 4, 4) G(5)' -o generated", "the generated code of a format, to read"},
    {"compile", "voxc compile 'R(4, 4, 4) G(5)' --emit=header -o shaders",
     "the traversal as functions, for a shader"},
    {"build", "voxc build 'R(3, 3, 3) G(3)' builtin:terrain -o terrain.hvx",
     "a built-in scene of 64 voxels an axis"},
    {"build", "voxc build 'R(4, 4, 4) G(5)' --whole-level-dedup model.obj -o model.hvx",
     "a mesh, 512 voxels on its longest axis"},
    {"build", "voxc build auto model.ply --resolution 1024 -o model.hvx",
     "in the format that voxc suggest chooses"},
    {"edit", "voxc edit terrain.hvx --clear 0,0,0,16,16,16 --fill 4,40,4,8,44,8=ff8000 -o edited.hvx",
     "a box emptied, and a small one of orange"},
    {"edit", "voxc edit terrain.hvx --paste whole.hvx@0,0,0 -o pasted.hvx",
     "the voxels of one volume put over another's"},
    {"plan", "voxc plan 'R(4, 4, 4) G(7)' city.obj --parts 64 -o city.plan",
     "a build in 64 parts of equal cost"},
    {"submit", "voxc submit city.plan --local 8", "all parts, on eight processes of this machine"},
    {"submit", "voxc submit city.plan --slurm --partition long", "the same as arrays of jobs under Slurm"},
    {"status", "voxc status city.plan", "what is done and what is missing"},
    {"merge", "voxc merge part-*.hvf -o whole.hvx", "fragments, in any order, as one volume"},
    {"split", "voxc split whole.hvx --fragment 1/4 -o quarter.hvf",
     "a quarter of a volume: of the fragments 0 to 3 the second"},
    {"render", "voxc render terrain.hvx -o terrain.png",
     "a picture with sun and sky, from a view that is found"},
    {"render", "voxc render terrain.hvx --style heatmap --view top -o cost.png",
     "how many lookups each ray took"},
    {"run", "voxc run model.obj -o model.png", "from a mesh to a picture, in a format that is chosen"},
    {"run", "voxc run 'G(9)' model.vox -o model.png --volume model.hvx",
     "in this format, keeping the volume"},
    {"trace", "voxc trace terrain.hvx --rays rays.bin -o hits.bin", "24 bytes a ray in, 24 bytes a hit out"},
    {"verify", "voxc verify terrain.hvx --rays 100000",
     "the file's structure, and rays against the exact oracle"},
    {"verify", "voxc verify terrain.hvx --against builtin:terrain", "that it has every voxel of its input"},
    {"accuracy", "voxc accuracy terrain.hvx -o accuracy", "exact and fast kernels: speed beside error"},
    {"bench", "voxc bench model.obj --formats 'G(9);R(4, 4, 4) G(5)' -o results",
     "size, speed and error of two formats"},
    {"export", "voxc export model.hvx -o model.vox", "as a MagicaVoxel model"},
    {"export", "voxc export model.hvx -o model.html",
     "a page that shows it in any browser, without a network"},
    {"attach", "voxc attach terrain.hvx --normals -o with-normals.hvx",
     "the direction of the surface, for each voxel"},
    {"view", "voxc view model.obj", "a window in which to turn it, or fly inside"},
    {"facts", "voxc facts model.obj --resolution 256", "colours, emptiness and repetition of a scene"},
    {"suggest", "voxc suggest model.obj", "one format, why, and the command that builds it"},
    {"search", "voxc search model.obj --budget 60s -o results", "the best formats of each size, measured"},
    {"info", "voxc info terrain.hvx", "format, size and streams"},
    {"info", "voxc info model.obj", "the triangles, box and colours of a mesh; nothing is built"},
    {"cache", "voxc cache --clear",
     "compiled code of earlier runs, which is made again when it is asked for"},
    {"doctor", "voxc doctor", "devices, caches, scratch space, the viewer and the Python module"},
    {"devices", "voxc devices", "numbers and names for --device"},
};

bool takesFormat(const CommandLine &command) { return command.find("FORMAT").has_value(); }

} // namespace

std::span<const Example> examples() { return kExamples; }

std::string formatHelp() {
  std::string text =
      "FORMAT names levels from the top down, each with the log2 of its cells along an axis:\n";
  for (const LevelKind *kind : levelKinds()) {
    std::string parameters;
    for (const ParameterKind &parameter : kind->parameters)
      parameters += (parameters.empty() ? "" : ", ") + std::string(parameter.name);
    text += std::string("  ") + kind->letter + "(" + parameters + "): " + std::string(kind->summary) + "\n";
  }
  return text + "So 'R(4, 4, 4) G(5)' is a grid of 16 x 16 x 16 cells, each a sparse voxel DAG of 32 voxels "
                "an axis, for 512 in all. docs/formats.md has the rules; 'auto', where it is taken, lets "
                "voxc choose.\n";
}

void addExamples(const CommandLine &command) {
  std::string text;
  for (const Example &example : kExamples)
    if (example.command == command.name())
      text += (text.empty() ? "Examples:\n" : "") + std::string("  ") + std::string(example.line) +
              "\n      " + std::string(example.does) + "\n";
  if (takesFormat(command))
    text += (text.empty() ? "" : "\n") + formatHelp();
  if (!text.empty())
    text.pop_back();
  if (const std::string before = command.footer(); !before.empty())
    text = before + (text.empty() ? "" : "\n\n" + text);
  command.footer(text);
}

} // namespace voxc::tool
