// What `voxc compile` can write.
#include "Artefacts.h"

#include "InterfaceText.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/Translate.h"
#include "voxc/Support/EmbeddedFile.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>

namespace voxc::tool {

namespace {

/// What artefacts are made of; kernels are compiled when they are first asked for.
class Generator {
public:
  static Expected<Generator> create(const Format &format, const KernelChoices &choices) {
    auto plan = makePlan(format, {.addressing = choices.addressing});
    auto cpuPlan = makePlan(format, kCpuPlan);
    if (!plan || !cpuPlan)
      return plan ? cpuPlan.error() : plan.error();
    if (choices.name.empty())
      return Generator(format, std::move(*plan), std::move(*cpuPlan), choices, headerName(plan->layout));
    if (!isHeaderName(choices.name))
      return Error::usage("--name takes letters, digits and single underscores between them, not '" +
                          choices.name + "'");
    return Generator(format, std::move(*plan), std::move(*cpuPlan), choices, choices.name);
  }

  const Format &format() const { return format_; }
  const Plan &plan() const { return plan_; }
  const Plan &cpuPlan() const { return cpuPlan_; }
  const KernelChoices &choices() const { return choices_; }
  const std::string &name() const { return name_; }

  Expected<const Plan *> headerPlan() {
    if (plan_.detail != Detail::Full)
      return Error::input("the functions of a header stop at voxels alone: leave out --detail cone");
    if (!headerPlan_) {
      Expected<Plan> plan = makePlan(format_, kHeaderPlan);
      if (!plan)
        return plan.error();
      headerPlan_ = std::move(*plan);
    }
    return &*headerPlan_;
  }

  Expected<const Kernel *> kernel() {
    if (!kernel_) {
      Expected<Kernel> kernel = compileGlsl(emitIntersect(plan_), plan_, choices_.optimise);
      if (!kernel)
        return kernel.error();
      kernel_ = std::move(*kernel);
    }
    return &*kernel_;
  }

private:
  Generator(Format format, Plan plan, Plan cpuPlan, const KernelChoices &choices, std::string name)
      : format_(std::move(format)), plan_(std::move(plan)), cpuPlan_(std::move(cpuPlan)), choices_(choices),
        name_(std::move(name)) {}

  Format format_;
  Plan plan_;
  Plan cpuPlan_; ///< The same for this processor.
  KernelChoices choices_;
  std::string name_; ///< Of what is in a header.
  std::optional<Plan> headerPlan_;
  std::optional<Kernel> kernel_;
};

Expected<std::string> makeIr(Generator &generator) { return printIr(generator.format()); }
Expected<std::string> makePlanText(Generator &generator) { return printPlan(generator.plan()); }
Expected<std::string> makeConstruct(Generator &generator) { return emitConstruct(generator.plan()); }
Expected<std::string> makeGlsl(Generator &generator) { return emitIntersect(generator.plan()); }
Expected<std::string> makeCpp(Generator &generator) {
  return emitIntersectCpp(generator.cpuPlan(), generator.choices().cpu.symbol);
}

Expected<std::string> makeSpirv(Generator &generator) {
  Expected<const Kernel *> kernel = generator.kernel();
  if (!kernel)
    return kernel.error();
  const auto bytes = std::as_bytes(std::span((*kernel)->spirv));
  return std::string(reinterpret_cast<const char *>(bytes.data()), bytes.size());
}

Expected<std::string> makeSpirvText(Generator &generator) {
  Expected<const Kernel *> kernel = generator.kernel();
  return kernel ? disassemble(**kernel) : Expected<std::string>(kernel.error());
}

/// Kernels for the devices of other interfaces, which run every loop to its end.
template <ShadingLanguage language> Expected<std::string> makeTranslation(Generator &generator) {
  Expected<Plan> plan =
      makePlan(generator.format(), {.addressing = generator.choices().addressing, .loops = Loops::Whole});
  if (!plan)
    return plan.error();
  const Expected<Kernel> kernel = compileGlsl(emitIntersect(*plan), *plan, generator.choices().optimise);
  return kernel ? translateKernel(*kernel, language) : Expected<std::string>(kernel.error());
}

Expected<std::string> makeInterface(Generator &generator) {
  Expected<const Kernel *> kernel = generator.kernel();
  return kernel ? interfaceText(toString(generator.format()), **kernel)
                : Expected<std::string>(kernel.error());
}

Expected<std::string> makeCpuObject(Generator &generator) {
  return compileCpuObject(generator.format(), generator.choices().cpu);
}

Expected<std::string> makeHeader(Generator &generator) {
  Expected<const Plan *> plan = generator.headerPlan();
  return plan ? emitHeader(**plan, generator.name()) : Expected<std::string>(plan.error());
}

Expected<std::string> makeC(Generator &generator) {
  Expected<const Plan *> plan = generator.headerPlan();
  return plan ? emitCHeader(**plan, generator.name()) : Expected<std::string>(plan.error());
}

Expected<std::string> makeWebGl(Generator &generator) {
  Expected<const Plan *> plan = generator.headerPlan();
  return plan ? emitWebGl(**plan, generator.name()) : Expected<std::string>(plan.error());
}

Expected<std::string> makeIntersection(Generator &generator) {
  Expected<const Plan *> plan = generator.headerPlan();
  if (!plan)
    return plan.error();
  for (const RayStage stage : {RayStage::Intersection, RayStage::ClosestHit})
    if (const auto module = compileRayShader(**plan, generator.name(), stage); !module)
      return module.error();
  return emitRayShader(**plan, generator.name(), RayStage::Intersection);
}

std::vector<Artefact> noCompanions(Generator &) { return {}; }

// So that a plain compiler finds what the texts include.
std::vector<Artefact> artefactsOf(std::span<const EmbeddedFile> embedded) {
  std::vector<Artefact> files;
  for (const EmbeddedFile &header : embedded)
    files.push_back({std::string(header.path), std::string(header.text)});
  return files;
}

std::vector<Artefact> constructCompanions(Generator &) { return artefactsOf(constructHeaders()); }
std::vector<Artefact> cppCompanions(Generator &) { return artefactsOf(intersectHeaders()); }

std::vector<Artefact> cpuCompanions(Generator &generator) {
  return {{"intersect.h", emitIntersectHeader(generator.cpuPlan(), generator.choices().cpu.symbol)}};
}

std::vector<Artefact> cCompanions(Generator &generator) {
  const Plan &plan = **generator.headerPlan(); // There is one: the header was made of it.
  const std::string &name = generator.name();
  return {{headerFile(name), emitHeader(plan, name)},
          {"voxc_" + name + "_c.cpp", emitCDefinitions(plan, name)}};
}

std::vector<Artefact> intersectionCompanions(Generator &generator) {
  const Plan &plan = **generator.headerPlan(); // There is one: the shader was made of it.
  const std::string &name = generator.name();
  return {{headerFile(name), emitHeader(plan, name)},
          {"voxc_" + name + ".rchit", emitRayShader(plan, name, RayStage::ClosestHit)}};
}

struct ArtefactKind {
  const char *name; ///< As given to --emit.
  const char *file; ///< A * stands for the name of what is in a header.
  Expected<std::string> (*make)(Generator &generator);
  std::vector<Artefact> (*companions)(Generator &generator);
};

constexpr ArtefactKind kArtefacts[] = {
    {"ir", "format.vir", makeIr, noCompanions},
    {"plan", "format.plan", makePlanText, noCompanions},
    {"construct", "construct.cpp", makeConstruct, constructCompanions},
    {"glsl", "intersect.glsl", makeGlsl, noCompanions},
    {"spirv", "intersect.spv", makeSpirv, noCompanions},
    {"spvasm", "intersect.spvasm", makeSpirvText, noCompanions},
    {"interface", "intersect.json", makeInterface, noCompanions},
    {"hlsl", "intersect.hlsl", makeTranslation<ShadingLanguage::Hlsl>, noCompanions},
    {"msl", "intersect.metal", makeTranslation<ShadingLanguage::Msl>, noCompanions},
    {"cpp", "intersect.cpp", makeCpp, cppCompanions},
    {"cpu", "intersect.o", makeCpuObject, cpuCompanions},
    {"header", "voxc_*.h", makeHeader, noCompanions},
    {"c", "voxc_*_c.h", makeC, cCompanions},
    {"webgl", "voxc_*.glsl", makeWebGl, noCompanions},
    {"rint", "voxc_*.rint", makeIntersection, intersectionCompanions},
};

const ArtefactKind &findArtefact(const std::string &name) {
  return *std::ranges::find_if(kArtefacts, [&](const ArtefactKind &kind) { return name == kind.name; });
}

std::string fileOf(const ArtefactKind &kind, const std::string &name) {
  std::string file = kind.file;
  if (const std::size_t star = file.find('*'); star != std::string::npos)
    file.replace(star, 1, name);
  return file;
}

} // namespace

std::vector<std::string> artefactNames() {
  std::vector<std::string> names;
  for (const ArtefactKind &kind : kArtefacts)
    names.emplace_back(kind.name);
  return names;
}

Expected<std::vector<Artefact>> makeArtefacts(const Format &format, const std::vector<std::string> &kinds,
                                              const KernelChoices &choices, bool alone) {
  auto generator = Generator::create(format, choices);
  if (!generator)
    return generator.error();
  std::vector<Artefact> artefacts;
  for (const std::string &name : kinds) {
    const ArtefactKind &kind = findArtefact(name);
    Expected<std::string> contents = kind.make(*generator);
    if (!contents)
      return contents.error();
    artefacts.push_back({fileOf(kind, generator->name()), std::move(*contents)});
    if (!alone)
      std::ranges::move(kind.companions(*generator), std::back_inserter(artefacts));
  }
  return artefacts;
}

} // namespace voxc::tool
