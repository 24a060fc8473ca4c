// What stands outermost, line by line.
#include "Glsl/Print.h"
#include "Glsl/Printer.h"
#include "Glsl/Wrap.h"

#include <algorithm>
#include <utility>

namespace voxc::glsl {

std::string joined(const std::vector<std::string> &parts) {
  std::string text;
  for (const std::string &part : parts)
    text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string Printer::print(const Module &module) {
  text_.clear();
  begin(module);
  for (const Declaration &part : module.declarations)
    if (!part.isElsewhere)
      declaration(part);
  return wrapped(text_);
}

void Printer::line(int depth, const std::string &text, const std::string &behind) {
  text_.append(static_cast<std::size_t>(2 * depth), ' ').append(text);
  text_ += (behind.empty() ? "" : " " + behind) + "\n";
}

/// Lines of a comment that are too long are one, which is broken anew. Those that are indented are code.
void Printer::above(const Notes &notes, int depth) {
  const auto isTooLong = [&](const std::string &text) {
    return text.size() + static_cast<std::size_t>(2 * depth) > kMostColumns;
  };
  const bool fills = std::ranges::any_of(notes.above, isTooLong);
  std::string before; // Comment that is not ended.
  const auto end = [&] {
    if (!before.empty())
      line(depth, std::exchange(before, {}));
  };
  for (const std::string &text : notes.above) {
    const bool goesOn = fills && !before.empty() && text.starts_with("// ") && !text.starts_with("//  ");
    if (!goesOn)
      end();
    if (!text.empty())
      before += goesOn ? text.substr(2) : text;
    else if (!text_.empty())
      text_ += '\n';
  }
  end();
}

void Printer::declaration(const Declaration &declaration) {
  above(declaration.notes, 0);
  const std::string &behind = declaration.notes.behind;
  switch (declaration.kind) {
  case Declaration::Kind::Directive:
    return line(0, declaration.name);
  case Declaration::Kind::Remark:
    return;
  case Declaration::Kind::Variable:
    return line(0, global(declaration), behind);
  case Declaration::Kind::Layout:
    return line(0, declaration.qualifiers + ";", behind);
  case Declaration::Kind::Block:
    return block(declaration);
  case Declaration::Kind::Structure:
    return structure(declaration);
  case Declaration::Kind::Function:
    return function(declaration);
  }
}

void Printer::block(const Declaration &declaration) {
  std::string members;
  for (const Variable &member : declaration.variables)
    members += this->member(member) + " ";
  line(0, beforeGlobal(declaration.qualifiers) + declaration.name + " { " + members + "};",
       declaration.notes.behind);
}

/// Comments behind members stand in one column.
void Printer::structure(const Declaration &declaration) {
  line(0, "struct " + declaration.name + " {");
  std::size_t width = 0;
  for (const Variable &member : declaration.variables)
    if (!member.notes.behind.empty())
      width = std::max(width, this->member(member).size());
  for (const Variable &member : declaration.variables) {
    above(member.notes, 1);
    std::string text = this->member(member);
    if (!member.notes.behind.empty())
      text.resize(width, ' ');
    line(1, text, member.notes.behind);
  }
  line(0, structureEnd(), declaration.notes.behind);
}

std::string Printer::member(const Variable &member) const { return Printer::variables({member}) + ";"; }

std::string Printer::global(const Declaration &variable) const {
  return beforeGlobal(variable.qualifiers) + variables(variable.variables) + ";";
}

std::string Printer::head(const Declaration &function) const {
  std::vector<std::string> parameters;
  parameters.reserve(function.parameters.size());
  for (const Parameter &one : function.parameters)
    parameters.push_back(parameter(one));
  return beforeFunction(function) + type(function.type) + " " + function.name + "(" + joined(parameters) +
         ")";
}

void Printer::function(const Declaration &declaration) {
  beginFunction(declaration);
  const std::string head = this->head(declaration);
  if (declaration.isPrototype)
    return line(0, head + ";");
  if (declaration.body.empty())
    return line(0, head + " {}");
  const Statement &first = declaration.body.front();
  const bool isSimple = first.kind == Statement::Kind::Return || first.kind == Statement::Kind::Expression;
  if (declaration.body.size() == 1 && isSimple && first.notes.above.empty() && first.notes.behind.empty())
    if (const std::string whole = head + " { " + simple(first) + "; }"; whole.size() <= kMostColumns)
      return line(0, whole);
  line(0, head + " {");
  body(declaration.body, true, 0);
}

std::string Printer::parameter(const Parameter &parameter) const {
  static constexpr const char *kPassings[] = {"", "const ", "out ", "inout "};
  return kPassings[static_cast<std::size_t>(parameter.passing)] + type(parameter.type) + " " + parameter.name;
}

std::string Printer::beforeFunction(const Declaration &function) const {
  return function.isSeldom ? "OUT_OF_LINE " : function.isInline ? "INLINE " : "";
}

std::string Printer::beforeGlobal(const std::string &qualifiers) const {
  return qualifiers.empty() ? "" : qualifiers + " ";
}

std::string print(const Module &module) { return Printer().print(module); }

} // namespace voxc::glsl
