// Filling of templates.
#include "Template.h"

#include <algorithm>
#include <vector>

namespace voxc {
namespace {

class Filler {
public:
  Filler(std::string_view text, const TemplateNames &names) : text_(text), names_(names) {}

  Expected<std::string> fill() {
    for (std::size_t begin = 0; begin < text_.size() && problem_.empty();) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size() - 1) + 1;
      ++lineNumber_;
      line(text_.substr(begin, end - begin));
      begin = end;
    }
    if (problem_.empty() && !branches_.empty())
      problem_ = "a %if has no %end";
    if (!problem_.empty())
      return Error::input("line " + std::to_string(lineNumber_) + ": " + problem_);
    return std::move(result_);
  }

private:
  /// An %if that has not ended.
  struct Branch {
    bool outside; ///< What is around it applies.
    bool applies;
    bool hasElse = false;
  };

  bool applies() const { return branches_.empty() || branches_.back().applies; }

  void line(std::string_view line) {
    if (line.starts_with('%'))
      return directive(line.substr(0, line.find_last_not_of(" \n") + 1));
    const std::size_t before = result_.size();
    holes(line);
    if (!applies()) // It was filled all the same: its names must be right.
      result_.resize(before);
  }

  void directive(std::string_view text) {
    if (text.starts_with("%if "))
      begin(text.substr(4));
    else if (text == "%else" && !branches_.empty() && !branches_.back().hasElse)
      branches_.back() = {branches_.back().outside, branches_.back().outside && !branches_.back().applies,
                          true};
    else if (text == "%end" && !branches_.empty())
      branches_.pop_back();
    else
      problem_ = "'" + std::string(text) + "' is no %if, %else or %end that fits here";
  }

  void begin(std::string_view name) {
    const auto condition = names_.conditions.find(name);
    if (condition == names_.conditions.end())
      problem_ = "there is no condition '" + std::string(name) + "'";
    else
      branches_.push_back({applies(), applies() && condition->second});
  }

  void holes(std::string_view line) {
    while (true) {
      const std::size_t at = line.find("${");
      const std::size_t end = line.find('}', at);
      result_ += line.substr(0, at);
      if (at == std::string_view::npos)
        return;
      const auto hole = names_.holes.find(line.substr(at + 2, end - at - 2));
      if (end == std::string_view::npos || hole == names_.holes.end()) {
        problem_ = "there is no hole '" + std::string(line.substr(at + 2, end - at - 2)) + "'";
        return;
      }
      result_ += hole->second;
      line.remove_prefix(end + 1);
    }
  }

  std::string_view text_;
  const TemplateNames &names_;
  std::string result_;
  std::string problem_;
  std::vector<Branch> branches_;
  int lineNumber_ = 0;
};

} // namespace

Expected<std::string> fillTemplate(std::string_view text, const TemplateNames &names) {
  return Filler(text, names).fill();
}

std::string_view runtimeFile(std::span<const EmbeddedFile> files, std::string_view path) {
  const auto file = std::ranges::find(files, path, &EmbeddedFile::path);
  return file == files.end() ? "#error a runtime file is missing\n" : file->text;
}

std::string fillFile(std::span<const EmbeddedFile> files, std::string_view path, const TemplateNames &names) {
  auto text = fillTemplate(runtimeFile(files, path), names);
  return text ? std::move(*text) : "#error " + std::string(path) + ", " + text.error().message + "\n";
}

} // namespace voxc
