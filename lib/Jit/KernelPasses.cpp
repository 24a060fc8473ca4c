// A kernel is some hundred small functions, each of which is in one of about ten large ones in the end. So
// the small ones are made smaller once, before they are copied, and the large ones are gone through once,
// with no pass that was not seen to make kernels faster: in about half the time of -O3, whose packets are
// slower.
#include "KernelPasses.h"

#include "Jit/Packet/PacketPass.h"
#include "Jit/Packet/WideMasks.h"

#include <llvm/IR/DiagnosticHandler.h>
#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/IR/DiagnosticPrinter.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/raw_ostream.h>

#include <string>

namespace voxc {
namespace {

/// All passes in their order, as LLVM reads them.
std::string pipeline() {
  const std::string combine = "instcombine<max-iterations=1;no-use-loop-info;no-verify-fixpoint>";
  // Branches become no tables, and loops keep their heads, where packets will follow them.
  const std::string blocks = "simplifycfg<bonus-inst-threshold=1;no-switch-to-lookup;keep-loops>";
  // Once there are packets, what both ways of a branch do is done before or behind it.
  const std::string lateBlocks = "simplifycfg<bonus-inst-threshold=1;no-switch-to-lookup;no-keep-loops;"
                                 "switch-range-to-icmp;hoist-common-insts;sink-common-insts>";
  const std::string small = "sroa<preserve-cfg>,early-cse<>," + combine + "," + blocks;
  const std::string join = "always-inline,cgscc(inline),globaldce";
  const std::string loops = "loop-mssa(loop-instsimplify,loop-simplifycfg,licm<no-allowspeculation>,"
                            "loop-rotate,licm,simple-loop-unswitch<no-nontrivial;trivial>)";
  const std::string large = "sroa<modify-cfg>,early-cse<memssa>," + blocks + "," + combine + "," + blocks +
                            "," + loops + "," + blocks + "," + combine +
                            ",loop(indvars,loop-deletion,loop-unroll-full),"
                            "sroa<modify-cfg>,early-cse<memssa>," +
                            combine + ",adce," + blocks;
  // What an earlier branch has decided is not asked again, but has a way of its own. Not before there are
  // packets, which would go all of these ways; rays that go one by one gain a sixth by it.
  const std::string packets = "packet,early-cse<>,jump-threading,correlated-propagation," + blocks + "," +
                              combine + ",gvn," + combine + "," + lateBlocks + "," + combine +
                              ",loop-mssa(licm),instsimplify," + blocks + ",wide-masks,adce";
#ifdef NDEBUG
  const std::string check;
#else
  const std::string check = ",verify";
#endif
  return "function<eager-inv>(" + small + ")," + join + ",function<eager-inv>(" + large + "," + packets +
         ")" + check;
}

/// Keeps the errors that passes tell of; LLVM's own handler would end the process.
class ErrorLog final : public llvm::DiagnosticHandler {
public:
  explicit ErrorLog(std::string &log) : log_(log) {}

  bool handleDiagnostics(const llvm::DiagnosticInfo &diagnostic) override {
    if (diagnostic.getSeverity() != llvm::DS_Error)
      return true;
    llvm::raw_string_ostream stream(log_);
    llvm::DiagnosticPrinterRawOStream printer(stream);
    diagnostic.print(printer);
    return true;
  }

private:
  std::string &log_;
};

} // namespace

Expected<void> runKernelPasses(llvm::Module &module, llvm::TargetMachine &machine) {
  llvm::LoopAnalysisManager loops;
  llvm::FunctionAnalysisManager functions;
  llvm::CGSCCAnalysisManager calls;
  llvm::ModuleAnalysisManager modules;
  llvm::PassBuilder builder(&machine);
  builder.registerModuleAnalyses(modules);
  builder.registerCGSCCAnalyses(calls);
  builder.registerFunctionAnalyses(functions);
  builder.registerLoopAnalyses(loops);
  builder.crossRegisterProxies(loops, functions, calls, modules);
  builder.registerPipelineParsingCallback([](llvm::StringRef name, llvm::FunctionPassManager &passes,
                                             llvm::ArrayRef<llvm::PassBuilder::PipelineElement>) {
    if (name == "packet")
      passes.addPass(PacketPass());
    else if (name == "wide-masks")
      passes.addPass(WideMasksPass());
    else
      return false;
    return true;
  });
  llvm::ModulePassManager passes;
  llvm::cantFail(builder.parsePassPipeline(passes, pipeline()));
  std::string errors;
  llvm::LLVMContext &context = module.getContext();
  auto previous = context.getDiagnosticHandler();
  context.setDiagnosticHandler(std::make_unique<ErrorLog>(errors));
  passes.run(module, modules);
  context.setDiagnosticHandler(std::move(previous));
  return errors.empty() ? Expected<void>() : Error::input(errors);
}

} // namespace voxc
