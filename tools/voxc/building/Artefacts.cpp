// What `voxc compile` can write.
#include "building/Artefacts.h"

#include "building/InterfaceText.h"

#include "voxc/Emit/Emit.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Kernel/Translate.h"
#include "voxc/Layout/Edits.h"
#include "voxc/Support/EmbeddedFile.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <span>

namespace voxc::tool {

namespace {

/// Plans for one target each, made of a format when they are first asked for; or one plan, if it is for that.
class Plans {
public:
  Plans(const std::variant<Format, Plan> &source, const PlanOptions &device)
      : source_(source), device_(device) {}

  /// The format, unless there is a plan alone.
  const Format *format() const { return std::get_if<Format>(&source_); }
  /// The plan that was given; null without.
  const Plan *given() const { return std::get_if<Plan>(&source_); }

  Expected<const Plan *> device() { return planFor(EmitTarget::Device, device_); }
  /// For devices of other interfaces, which run every loop to its end.
  Expected<const Plan *> translated() {
    return planFor(EmitTarget::Device, {.addressing = device_.addressing, .loops = Loops::Whole},
                   translated_);
  }
  Expected<const Plan *> cpu() { return planFor(EmitTarget::Processor, kCpuPlan); }
  Expected<const Plan *> functions(EmitTarget target = EmitTarget::Functions) {
    return planFor(target, kHeaderPlan);
  }

private:
  Expected<const Plan *> planFor(EmitTarget target, const PlanOptions &options) {
    return planFor(target, options, made_[static_cast<std::size_t>(target)]);
  }

  Expected<const Plan *> planFor(EmitTarget target, const PlanOptions &options, std::optional<Plan> &made) {
    if (given()) {
      const std::string problem = problemOf(*given(), target);
      return problem.empty() ? Expected<const Plan *>(given()) : Error::input(problem);
    }
    if (!made)
      made = VOXC_TRY(makePlan(*format(), options));
    return &*made;
  }

  std::variant<Format, Plan> source_;
  PlanOptions device_;
  std::array<std::optional<Plan>, 4> made_; ///< In the order of `EmitTarget`.
  std::optional<Plan> translated_;
};

/// What artefacts are made of; kernels are compiled when they are first asked for.
class Generator {
public:
  static Expected<Generator> create(const std::variant<Format, Plan> &source, const KernelChoices &choices) {
    Generator generator(source, choices);
    if (choices.name.empty()) {
      const Format *const format = generator.plans_.format();
      generator.name_ = headerName(format ? layoutOf(*format) : generator.plans_.given()->layout);
      return generator;
    }
    if (!isHeaderName(choices.name))
      return Error::usage("--name takes letters, digits and single underscores between them, not '" +
                          choices.name + "'");
    generator.name_ = choices.name;
    return generator;
  }

  Plans &plans() { return plans_; }
  const KernelChoices &choices() const { return choices_; }
  const std::string &name() const { return name_; }

  Expected<const Plan *> headerPlan(EmitTarget target = EmitTarget::Functions) {
    const auto asked = VOXC_TRY(plans_.given() ? plans_.given() : plans_.device());
    if (asked->stopsAboveVoxels())
      return Error::input("the functions of a header stop at voxels alone: leave out --detail cone");
    return plans_.functions(target);
  }

  Expected<const Kernel *> kernel() {
    if (!kernel_) {
      const auto plan = VOXC_TRY(plans_.device());
      kernel_ = VOXC_TRY(compileKernel(*plan, choices_.optimise));
    }
    return &*kernel_;
  }

private:
  Generator(const std::variant<Format, Plan> &source, const KernelChoices &choices)
      : plans_(source, choices.device), choices_(choices) {}

  Plans plans_;
  KernelChoices choices_;
  std::string name_; ///< Of what is in a header.
  std::optional<Kernel> kernel_;
};

/// What a function makes of a plan, if there is one.
template <typename Print> Expected<std::string> printed(const Expected<const Plan *> &plan, Print print) {
  return plan ? Expected<std::string>(print(**plan)) : plan.error();
}

Expected<std::string> makeIr(Generator &generator) {
  const Format *const format = generator.plans().format();
  return format ? Expected<std::string>(printIr(*format))
                : Error::input("a plan has no level IR: what it was lowered from is a format's");
}

Expected<std::string> makePlanText(Generator &generator) {
  const Plan *const given = generator.plans().given();
  return given ? Expected<std::string>(printPlan(*given)) : printed(generator.plans().device(), printPlan);
}

Expected<std::string> makeCpuPlanText(Generator &generator) {
  return printed(generator.plans().cpu(), printPlan);
}

Expected<std::string> makeHeaderPlanText(Generator &generator) {
  return printed(generator.headerPlan(), printPlan);
}

Expected<std::string> makeConstruct(Generator &generator) {
  const Plan *const given = generator.plans().given(); // Construction is the same for all targets.
  return given ? Expected<std::string>(emitConstruct(*given))
               : printed(generator.plans().device(), emitConstruct);
}

Expected<std::string> makeEdit(Generator &generator) {
  const Plan *const given = generator.plans().given();
  const auto plan = VOXC_TRY(given ? Expected<const Plan *>(given) : generator.plans().device());
  if (const std::string reason = whyNoEdits(plan->layout); !reason.empty())
    return Error::input("this format cannot be edited: " + reason);
  return emitEdit(*plan);
}

Expected<std::string> makeGlsl(Generator &generator) {
  return printed(generator.plans().device(), emitIntersect);
}

Expected<std::string> makeCpp(Generator &generator) {
  if (!isFunctionName(generator.choices().cpu.symbol))
    return Error::usage("'" + generator.choices().cpu.symbol + "' is no name of a C function");
  return printed(generator.plans().cpu(),
                 [&](const Plan &plan) { return emitIntersectCpp(plan, generator.choices().cpu.symbol); });
}

Expected<std::string> makeSpirv(Generator &generator) {
  auto kernel = VOXC_TRY(generator.kernel());
  const auto bytes = std::as_bytes(std::span(kernel->spirv));
  return std::string(reinterpret_cast<const char *>(bytes.data()), bytes.size());
}

Expected<std::string> makeSpirvText(Generator &generator) {
  Expected<const Kernel *> kernel = generator.kernel();
  return kernel ? disassemble(**kernel) : Expected<std::string>(kernel.error());
}

template <ShadingLanguage language> Expected<std::string> makeTranslation(Generator &generator) {
  const auto plan = VOXC_TRY(generator.plans().translated());
  const Expected<Kernel> kernel = compileKernel(*plan, generator.choices().optimise);
  return kernel ? translateKernel(*kernel, language) : Expected<std::string>(kernel.error());
}

Expected<std::string> makeInterface(Generator &generator) {
  auto kernel = VOXC_TRY(generator.kernel());
  return interfaceText((*generator.plans().device())->layout.format, *kernel);
}

Expected<std::string> makeCpuObject(Generator &generator) {
  const Expected<const Plan *> plan = generator.plans().cpu();
  return plan ? compileCpuObject(**plan, generator.choices().cpu) : plan.error();
}

Expected<std::string> makeHeader(Generator &generator) {
  return printed(generator.headerPlan(), [&](const Plan &plan) {
    return emitHeader(plan, generator.name(), generator.choices().language);
  });
}

Expected<std::string> makeC(Generator &generator) {
  return printed(generator.headerPlan(),
                 [&](const Plan &plan) { return emitCHeader(plan, generator.name()); });
}

Expected<std::string> makeWebGl(Generator &generator) {
  return printed(generator.headerPlan(EmitTarget::FirstHits), [&](const Plan &plan) {
    return emitHeader(plan, generator.name(), HeaderLanguage::GlslEs);
  });
}

Expected<std::string> makeIntersection(Generator &generator) {
  auto plan = VOXC_TRY(generator.headerPlan());
  for (const RayStage stage : {RayStage::Intersection, RayStage::ClosestHit})
    VOXC_TRY(compileRayShader(*plan, generator.name(), stage));
  return emitRayShader(*plan, generator.name(), RayStage::Intersection);
}

std::vector<Artefact> noCompanions(Generator &) { return {}; }

// So that a plain compiler finds what the texts include.
std::vector<Artefact> artefactsOf(std::span<const EmbeddedFile> embedded) {
  std::vector<Artefact> files;
  for (const EmbeddedFile &header : embedded)
    files.push_back({std::string(header.path), std::string(header.text)});
  return files;
}

std::vector<Artefact> constructCompanions(Generator &generator) {
  return artefactsOf(constructHeadersOf(*makeConstruct(generator))); // There is one: it was made before.
}
std::vector<Artefact> editCompanions(Generator &generator) {
  return artefactsOf(constructHeadersOf(*makeEdit(generator)));
}
std::vector<Artefact> cppCompanions(Generator &) { return artefactsOf(intersectHeaders()); }

std::vector<Artefact> cpuCompanions(Generator &generator) {
  const Plan &plan = **generator.plans().cpu(); // There is one: the object was made of it.
  return {{"intersect.h", emitIntersectHeader(plan, generator.choices().cpu.symbol)}};
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
    {"cpu-plan", "cpu.plan", makeCpuPlanText, noCompanions},
    {"header-plan", "header.plan", makeHeaderPlanText, noCompanions},
    {"construct", "construct.cpp", makeConstruct, constructCompanions},
    {"edit", "edit.cpp", makeEdit, editCompanions},
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

/// A header's name ends as its language has it.
std::string fileOf(const ArtefactKind &kind, const Generator &generator) {
  const std::string &name = generator.name();
  if (kind.make == makeHeader)
    return headerFile(name, generator.choices().language);
  std::string file = kind.file;
  if (const std::size_t star = file.find('*'); star != std::string::npos)
    file.replace(star, 1, name);
  return file;
}

/// Adds a file, once. Error: another one has its name.
Expected<void> add(Artefact artefact, std::vector<Artefact> &artefacts) {
  const auto same = std::ranges::find(artefacts, artefact.file, &Artefact::file);
  if (same == artefacts.end())
    artefacts.push_back(std::move(artefact));
  else if (same->contents != artefact.contents)
    return Error::usage("two of the kinds of --emit would be '" + artefact.file +
                        "'; write them to two folders");
  return {};
}

} // namespace

std::vector<std::string> artefactNames() {
  std::vector<std::string> names;
  for (const ArtefactKind &kind : kArtefacts)
    names.emplace_back(kind.name);
  return names;
}

Expected<std::vector<Artefact>> makeArtefacts(const std::variant<Format, Plan> &source,
                                              const std::vector<std::string> &kinds,
                                              const KernelChoices &choices, bool alone) {
  auto generator = VOXC_TRY(Generator::create(source, choices));
  std::vector<Artefact> artefacts;
  for (const std::string &name : kinds) {
    const ArtefactKind &kind = findArtefact(name);
    auto contents = VOXC_TRY(kind.make(generator));
    VOXC_TRY(add({fileOf(kind, generator), std::move(contents)}, artefacts));
    if (!alone)
      for (Artefact &companion : kind.companions(generator))
        VOXC_TRY(add(std::move(companion), artefacts));
  }
  return artefacts;
}

} // namespace voxc::tool
