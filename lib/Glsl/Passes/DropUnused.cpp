// What nothing comes to: functions, structs, constants; parameters, members and variables that nothing reads.
#include "Glsl/Passes.h"
#include "Glsl/Visit.h"

#include <algorithm>
#include <map>
#include <utility>

namespace voxc::glsl {
namespace {

using Kind = Expression::Kind;
using Outer = Declaration::Kind;

class Dropper {
public:
  Dropper(Module &module, const Names &roots) : module_(module), roots_(roots) {}

  void run() {
    for (bool changed = true; changed;) {
      effects_ = functionsWithEffects(module_);
      noteNames();
      changed = dropVariables();
      changed |= dropMembers();
      changed |= dropParameters();
      changed |= dropDeclarations();
    }
  }

private:
  void noteNames() {
    functions_.clear();
    structures_.clear();
    for (const Declaration &declaration : module_.declarations)
      if (declaration.kind == Outer::Function || declaration.kind == Outer::Structure)
        (declaration.kind == Outer::Function ? functions_ : structures_).insert(declaration.name);
  }

  bool isKept(const std::string &name) const { return roots_.contains(name); }

  bool isPure(const Expression &expression) const {
    bool pure = true;
    forEachExpression(expression, [&](const Expression &inner) {
      pure &= inner.kind != Kind::Assignment && inner.kind != Kind::Postfix && inner.text != "++" &&
              inner.text != "--" && !(inner.kind == Kind::Call && effects_.contains(inner.text));
    });
    return pure;
  }

  /// A name of overloads with so many parameters.
  static std::string callOf(const std::string &name, std::size_t parameters) {
    return name + "/" + std::to_string(parameters);
  }

  static bool isReached(const Declaration &declaration, const Names &names) {
    const auto isNamed = [&](const Variable &variable) { return names.contains(variable.name); };
    switch (declaration.kind) {
    case Outer::Function:
      return names.contains(declaration.name) ||
             names.contains(callOf(declaration.name, declaration.parameters.size()));
    case Outer::Structure:
      return names.contains(declaration.name);
    case Outer::Variable:
      return isNamed(declaration.variables[0]);
    case Outer::Block:
      return names.contains(declaration.name) || std::ranges::any_of(declaration.variables, isNamed);
    default:
      return true;
    }
  }

  void addNames(const Declaration &declaration, Names &names) const {
    forEachType(declaration, [&](const std::string &type) { names.insert(type); });
    forEachExpression(declaration, [&](const Expression &expression) {
      if (expression.kind == Kind::Name || isConstructor(expression))
        names.insert(expression.text);
      else if (expression.kind == Kind::Call)
        names.insert(callOf(expression.text, expression.operands.size()));
    });
  }

  bool isConstructor(const Expression &expression) const {
    return expression.kind == Kind::Call && structures_.contains(expression.text);
  }

  /// What is used stands before its users, so that one way from the end to the begin finds all of it.
  bool dropDeclarations() {
    Names names = roots_;
    std::vector<Declaration> kept;
    for (auto at = module_.declarations.rbegin(); at != module_.declarations.rend(); ++at) {
      if (!isReached(*at, names))
        continue;
      addNames(*at, names);
      kept.push_back(std::move(*at));
    }
    const bool changed = kept.size() != module_.declarations.size();
    std::ranges::reverse(kept);
    module_.declarations = std::move(kept);
    return changed;
  }

  /// How often each variable of a function is named.
  static std::map<std::string, int, std::less<>> usesIn(const Declaration &function) {
    std::map<std::string, int, std::less<>> uses;
    forEachExpression(function, [&](const Expression &expression) {
      if (expression.kind == Kind::Name)
        ++uses[expression.text];
    });
    return uses;
  }

  bool dropVariables() {
    bool changed = false;
    for (Declaration &declaration : module_.declarations) {
      const auto uses = usesIn(declaration);
      const auto isUnused = [&](const Variable &variable) {
        return !uses.contains(variable.name) && (variable.initial.empty() || isPure(variable.initial[0]));
      };
      const auto drop = [&](Statement &statement) {
        changed |= std::erase_if(statement.variables, isUnused) > 0;
        changed |= doesNothing(statement);
        return doesNothing(statement) ||
               (statement.kind == Statement::Kind::Declaration && statement.variables.empty());
      };
      dropIn(declaration.body, drop);
    }
    return changed;
  }

  /// A call for the sake of effects that there are none of.
  bool doesNothing(const Statement &statement) const {
    return statement.kind == Statement::Kind::Expression && statement.expressions[0].kind == Kind::Call &&
           functions_.contains(statement.expressions[0].text) && isPure(statement.expressions[0]);
  }

  /// Erases the statements, of all that are inside others too, for which `drop` holds.
  template <typename Drop> static void dropIn(std::vector<Statement> &statements, const Drop &drop) {
    std::erase_if(statements, drop);
    for (Statement &statement : statements) {
      dropIn(statement.body, drop);
      dropIn(statement.otherwise, drop);
      statement.isBraced |= statement.body.empty() && statement.kind != Statement::Kind::Block;
    }
  }

  /// Parameters that their functions do not name, unless somebody outside calls these. Overloads have one
  /// fate.
  bool dropParameters() {
    std::map<std::string, std::vector<bool>, std::less<>> unused;
    for (const Declaration &declaration : module_.declarations)
      if (declaration.kind == Outer::Function && !isKept(declaration.name)) {
        const auto uses = usesIn(declaration);
        std::vector<bool> flags;
        flags.reserve(declaration.parameters.size());
        for (const Parameter &parameter : declaration.parameters)
          flags.push_back(!uses.contains(parameter.name));
        if (const auto [at, isNew] = unused.emplace(declaration.name, flags); !isNew)
          at->second.assign(at->second.size(), false);
      }
    forEachCall([&](const Expression &call) {
      if (const auto found = unused.find(call.text); found != unused.end())
        for (std::size_t i = 0; i < call.operands.size() && i < found->second.size(); ++i)
          found->second[i] = found->second[i] && isPure(call.operands[i]);
    });
    std::erase_if(unused, [](const auto &entry) {
      return std::ranges::find(entry.second, true) == entry.second.end();
    });
    if (unused.empty())
      return false;
    const auto erase = [](auto &list, const std::vector<bool> &flags) {
      std::size_t i = 0;
      std::erase_if(list, [&](const auto &) { return flags[i++]; });
    };
    for (Declaration &declaration : module_.declarations)
      if (const auto found = unused.find(declaration.name);
          declaration.kind == Outer::Function && found != unused.end())
        erase(declaration.parameters, found->second);
    forEachCall([&](Expression &call) {
      if (const auto found = unused.find(call.text); found != unused.end())
        erase(call.operands, found->second);
    });
    return true;
  }

  template <typename Visit> void forEachCall(const Visit &visit) {
    for (Declaration &declaration : module_.declarations)
      forEachExpression(declaration, [&](Expression &expression) {
        if (expression.kind == Kind::Call)
          visit(expression);
      });
  }

  /// A member by the type of what it is of, where that is known; else by its name alone.
  static std::string keyOf(const Expression &member) {
    const std::string &whole = member.operands[0].type;
    return whole.empty() ? member.text : whole + "." + member.text;
  }

  /// Members of structs that are written alone. Where types are not known, a name that several structs have
  /// is read if one of them is.
  bool dropMembers() {
    Names read = readMembers();
    std::map<std::string, std::vector<bool>, std::less<>> unread; // Of each struct.
    Names dropped;
    for (Declaration &declaration : module_.declarations) {
      if (declaration.kind != Outer::Structure || isKept(declaration.name))
        continue;
      std::vector<bool> flags;
      flags.reserve(declaration.variables.size());
      for (const Variable &member : declaration.variables)
        flags.push_back(!read.contains(member.name) && !read.contains(declaration.name + "." + member.name));
      if (std::ranges::find(flags, true) == flags.end() || std::ranges::find(flags, false) == flags.end())
        continue; // Nothing, or all of it, which a language may not have.
      for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i]) {
          dropped.insert(declaration.variables[i].name);
          dropped.insert(declaration.name + "." + declaration.variables[i].name);
        }
      unread[declaration.name] = std::move(flags);
    }
    if (unread.empty() || !areConstructorsPure(unread))
      return false;
    for (Declaration &declaration : module_.declarations)
      dropMembers(declaration, unread, dropped);
    return true;
  }

  bool areConstructorsPure(const std::map<std::string, std::vector<bool>, std::less<>> &unread) {
    bool pure = true;
    forEachCall([&](const Expression &call) {
      if (const auto found = unread.find(call.text); found != unread.end())
        for (std::size_t i = 0; i < call.operands.size(); ++i)
          pure &= !found->second[i] || isPure(call.operands[i]);
    });
    return pure;
  }

  void dropMembers(Declaration &declaration,
                   const std::map<std::string, std::vector<bool>, std::less<>> &unread,
                   const Names &dropped) {
    const auto isWrite = [&](Statement &statement) {
      if (statement.kind != Statement::Kind::Expression || statement.expressions[0].kind != Kind::Assignment)
        return false;
      const Expression &to = statement.expressions[0].operands[0];
      return to.kind == Kind::Member && dropped.contains(keyOf(to)) &&
             isPure(statement.expressions[0].operands[1]);
    };
    dropIn(declaration.body, isWrite);
    if (const auto found = unread.find(declaration.name);
        declaration.kind == Outer::Structure && found != unread.end()) {
      std::size_t i = 0;
      std::erase_if(declaration.variables, [&](const Variable &) { return found->second[i++]; });
    }
    forEachExpression(declaration, [&](Expression &expression) {
      const auto found = unread.find(expression.text);
      if (expression.kind != Kind::Call || found == unread.end())
        return;
      std::size_t i = 0;
      std::erase_if(expression.operands, [&](const Expression &) { return found->second[i++]; });
    });
  }

  /// Those that are more than the left side of an assignment that is a statement of its own.
  Names readMembers() const {
    std::map<std::string, int, std::less<>> uses;
    for (const Declaration &declaration : module_.declarations) {
      forEachExpression(declaration, [&](const Expression &expression) {
        if (expression.kind == Kind::Member)
          ++uses[keyOf(expression)];
      });
      for (const Statement &statement : declaration.body)
        forEachStatement(statement, [&](const Statement &inner) {
          if (inner.kind != Statement::Kind::Expression || !inner.expressions[0].is(Kind::Assignment, "="))
            return;
          const Expression &to = inner.expressions[0].operands[0];
          if (to.kind != Kind::Member || !isPure(inner.expressions[0].operands[1]))
            return;
          forEachExpression(inner.expressions[0], [&](const Expression &expression) {
            if (expression.is(Kind::Member, to.text)) // Also where it is read to be written alone.
              --uses[keyOf(expression)];
          });
        });
    }
    Names read;
    for (const std::string &root : roots_)
      if (root.starts_with('.'))
        read.insert(root.substr(1));
    for (const auto &[name, count] : uses)
      if (count > 0)
        read.insert(name);
    return read;
  }

  Module &module_;
  const Names &roots_;
  Names effects_;
  Names functions_, structures_; ///< Of the module.
};

} // namespace

void dropUnused(Module &module, const Names &roots) { Dropper(module, roots).run(); }

} // namespace voxc::glsl
