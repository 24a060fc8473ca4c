// Passes: a module to one that means the same, in the way that a target needs it.
#pragma once

#include "Glsl/Tree.h"

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace voxc::glsl {

using Names = std::set<std::string, std::less<>>;

/// Names of constants, and their values: whole numbers, true, or false.
using Constants = std::map<std::string, std::string, std::less<>>;

/// Puts what an INLINE function returns in place of each call, and takes it away. It has a return alone, and
/// calls of it have arguments that do no more than give a value. Functions of one name differ in how many
/// parameters they have.
void inlineValues(Module &module);

/// Puts values in place of constants, and takes away what these decide: conditions and what they do not lead
/// to, and numbers that change nothing. What is written with numbers alone stays as it is written.
void fold(Module &module, const Constants &constants);

/// Takes away functions, structs, constants and variables that nothing from `roots` on names; parameters,
/// members and variables of functions that nothing reads; what is written to them; and calls that do nothing.
/// Overloads are told apart by how many parameters they have, and a root may be one of them: "cell/1" has one
/// parameter. Roots that are names alone keep their parameters and members; ".cell" is a member that is read
/// elsewhere.
void dropUnused(Module &module, const Names &roots);

/// Puts a prefix before the names of all functions, structs, constants and variables that stand outermost,
/// but those that have it. Members, parameters and variables of functions keep theirs.
void addPrefix(Module &module, std::string_view prefix);

/// The same in an expression of its own.
void fold(Expression &expression, const Constants &constants);

/// Puts the turns of each loop that is marked [[unroll]] one after the other, with numbers in place of what
/// it counts by. Such a loop is a `for` that counts an integer by one, between bounds that are numbers and
/// these constants, or sums of them; it has no break, no continue and no declarations but in inner blocks.
void unroll(Module &module, const Constants &constants);

/// Moves arrays of this name that functions declare to where the invocations of a workgroup have one each:
/// `uint path[N]` of f_x becomes shared uint path_x[N][gl_WorkGroupSize.x], of which each takes its column; x
/// is what stands behind the first "_" of the function's name.
void shareArrays(Module &module, std::string_view array);

/// Puts what leads (`Declaration::leads`) at the front, behind the types, constants and variables that it
/// needs, and the prototypes of the functions that it calls, which keep their place.
void lead(Module &module);

/// Gives the function of this name, and all that cannot do without it, one more parameter, the first, which
/// they hand on.
void addParameter(Module &module, std::string_view function, const Parameter &parameter);

/// Which conditionals become statements: of a module that is verified, one of ?:, && and ||.
enum class Unfolding {
  Effects, ///< Those whose later operands do more than give a value: where languages evaluate all of them.
  Calls, ///< ?: whose later operands call functions of the module, or give structs: where that is a function.
};

/// Makes statements of conditionals, so that no more is evaluated than before. What stands beside one in an
/// expression does not depend on what it writes: leaves have no such expressions.
void unfold(Module &module, Unfolding unfolding);

/// Gives each function a name of its own: to that of the second and further ones of a name, the type of the
/// last parameter is added. The module is verified.
void renameOverloads(Module &module);

/// Puts other names in place of types.
void renameTypes(Module &module, const std::map<std::string, std::string, std::less<>> &names);

/// Puts "_" behind members, parameters and variables that have one of these names, which a language keeps to
/// itself.
void renameReserved(Module &module, std::span<const std::string_view> reserved);

/// Where functions write to a parameter that comes in alone, they get a variable of its name to write to.
void copyParameters(Module &module);

/// The variables that a function writes to, by itself or by what it calls.
Names writtenIn(const Declaration &function,
                const std::map<std::string, const Declaration *, std::less<>> &functions);

/// The functions that do more than give a value: they write to an argument, or to what stands outermost.
Names functionsWithEffects(const Module &module);

} // namespace voxc::glsl
