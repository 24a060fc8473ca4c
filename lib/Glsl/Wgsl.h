// WGSL, the language of WebGPU, and what a module has to become before it is printed in it.
#pragma once

#include "Glsl/Passes.h"
#include "Glsl/Printer.h"

#include <map>

namespace voxc::glsl {

/// Of a module that `forWgsl` has made ready, and `verify` before that. `out` and `inout` parameters are
/// pointers; a conditional whose operands call nothing is a `select`. Lines of VOXC_LOAD(volume, index) call
/// the function `load`, which whoever includes the text declares.
class Wgsl : public Printer {
public:
  explicit Wgsl(std::string load) : load_(std::move(load)) {}

protected:
  void begin(const Module &module) override;
  std::string type(const std::string &name) const override;
  std::string bare(const Expression &expression) const override;
  int rank(const Expression &expression) const override;
  std::string parameter(const Parameter &parameter) const override;
  std::string head(const Declaration &function) const override;
  std::string member(const Variable &member) const override;
  std::string global(const Declaration &variable) const override;
  std::string variables(const std::vector<Variable> &variables) const override;
  std::string beforeLocal(const std::string &) const override { return ""; }
  std::string structureEnd() const override { return "}"; }
  void beginFunction(const Declaration &function) override;

private:
  std::string call(const Expression &call) const;
  std::string argument(const Expression &argument, const Parameter &parameter) const;
  std::string binary(const Expression &expression) const;
  std::string shiftOf(const Expression &by, const std::string &shifted) const;
  std::string assignment(const Expression &expression) const;
  std::string beside(const Expression &expression, const std::string &type, int leastRank) const;
  std::string typeOf(const Variable &variable) const;

  std::string load_;
  std::map<std::string, const Declaration *, std::less<>> functions_;
  Names pointers_; ///< Parameters of the function at hand.
  Names written_;  ///< Variables of it that change.
};

/// One name a function, no name that WGSL keeps to itself, variables where parameters change, and statements
/// in place of conditionals that call something. The module is verified.
void forWgsl(Module &module);

} // namespace voxc::glsl
