// A kernel is some hundred small functions, each of which is in one of about ten large ones in the end. So
// the small ones are made smaller once, before they are copied, and the large ones are gone through once,
// with no pass that was not seen to make kernels faster: a third of the time of -O3, whose kernels are
// slower.
#include "KernelPasses.h"

#include "Packet/PacketPass.h"

#include <llvm/IR/DiagnosticHandler.h>
#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/IR/DiagnosticPrinter.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/raw_ostream.h>

#include <string>

namespace voxc {
namespace {

const std::string kCombine = "instcombine<max-iterations=1;no-use-loop-info;no-verify-fixpoint>";
/// Branches stay as they are where packets will follow them: no tables, and no loops that are rotated into
/// one.
const std::string kBlocks = "simplifycfg<bonus-inst-threshold=1;no-switch-to-lookup;keep-loops>";
/// Once there are packets, what both ways of a branch do is done before or behind it.
const std::string kLateBlocks = "simplifycfg<bonus-inst-threshold=1;no-switch-to-lookup;no-keep-loops;"
                                "switch-range-to-icmp;hoist-common-insts;sink-common-insts>";

const std::string kSmall =
    "function<eager-inv>(sroa<preserve-cfg>,early-cse<>," + kCombine + "," + kBlocks + ")";
const std::string kJoin = "always-inline,cgscc(inline),globaldce";
const std::string kLoops =
    "loop-mssa(loop-instsimplify,loop-simplifycfg,licm<no-allowspeculation>,loop-rotate,licm,"
    "simple-loop-unswitch<no-nontrivial;trivial>)";
const std::string kLarge =
    "sroa<modify-cfg>,early-cse<memssa>," + kBlocks + "," + kCombine + "," + kBlocks + "," + kLoops + "," +
    kBlocks + "," + kCombine +
    ",loop(indvars,loop-deletion,loop-unroll-full),sroa<modify-cfg>,early-cse<memssa>," + kCombine +
    ",adce," + kBlocks;
/// From here on a packet has wide registers.
const std::string kPackets = "packet,early-cse<>," + kCombine + "," + kLateBlocks + "," + kCombine +
                             ",loop-mssa(licm),instsimplify," + kBlocks;
#ifdef NDEBUG
const std::string kCheck;
#else
const std::string kCheck = ",verify";
#endif

const std::string kPasses =
    kSmall + "," + kJoin + ",function<eager-inv>(" + kLarge + "," + kPackets + ")" + kCheck;

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
    return name == "packet";
  });
  llvm::ModulePassManager passes;
  llvm::cantFail(builder.parsePassPipeline(passes, kPasses)); // A text of ours.
  std::string errors;
  llvm::LLVMContext &context = module.getContext();
  auto usual = context.getDiagnosticHandler();
  context.setDiagnosticHandler(std::make_unique<ErrorLog>(errors));
  passes.run(module, modules);
  context.setDiagnosticHandler(std::move(usual));
  return errors.empty() ? Expected<void>() : Error::input(errors);
}

} // namespace voxc
