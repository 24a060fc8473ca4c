// Help texts.
#include "Help.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <sys/ioctl.h>
#include <unistd.h>

namespace voxc::tool {
namespace {

constexpr std::size_t kNameColumns = 30;  ///< Where descriptions begin.
constexpr int kPipedColumns = 100;        ///< Of help that goes to no terminal.
constexpr std::size_t kLeastColumns = 60; ///< A narrower terminal breaks lines itself.
constexpr std::size_t kMostColumns = 120; ///< Longer lines are hard to read.

class WrappedFormatter final : public CLI::Formatter {
public:
  std::string make_option(const CLI::Option *option, bool isPositional) const override {
    return row(make_option_name(option, isPositional) + make_option_opts(option), make_option_desc(option));
  }
  std::string make_subcommand(const CLI::App *command) const override {
    return row(command->get_display_name(true), command->get_description());
  }
  std::string make_description(const CLI::App *app) const override {
    return wrap(app->get_description(), columns()) + "\n";
  }
  std::string make_footer(const CLI::App *app) const override {
    return app->get_footer().empty() ? "" : wrap(app->get_footer(), columns()) + "\n";
  }
  std::string make_help(const CLI::App *app, std::string name, CLI::AppFormatMode mode) const override {
    // A blank line between groups, where CLI11 prints two.
    std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
    for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;)
      text.erase(at, 1);
    while (text.ends_with("\n\n"))
      text.pop_back();
    return text;
  }

private:
  static std::size_t columns() {
    return std::clamp(std::size_t(terminalColumns(STDOUT_FILENO, kPipedColumns)), kLeastColumns,
                      kMostColumns);
  }

  /// A name, and its description beside it or, behind a long name, below.
  static std::string row(const std::string &name, const std::string &description) {
    std::string text = "  " + name;
    if (description.empty())
      return text + "\n";
    if (text.size() + 2 > kNameColumns)
      text += "\n" + std::string(kNameColumns, ' ');
    else
      text.resize(kNameColumns, ' ');
    return text + wrap(description, columns(), kNameColumns, kNameColumns) + "\n";
  }
};

/// One line, whose first word begins at the column `begin`, and those after a break at `hang`.
std::string wrapLine(std::string_view line, std::size_t columns, std::size_t hang, std::size_t begin) {
  std::string wrapped;
  std::size_t column = begin;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t wordBegin = std::min(line.find_first_not_of(' ', at), line.size());
    const std::size_t wordEnd = std::min(line.find(' ', wordBegin), line.size());
    if (at > 0 && column + (wordEnd - at) > columns) {
      wrapped += "\n" + std::string(hang, ' ');
      column = hang;
      at = wordBegin;
    }
    wrapped += line.substr(at, wordEnd - at);
    column += wordEnd - at;
    at = wordEnd;
  }
  return wrapped;
}

} // namespace

int terminalColumns(int file, int fallback) {
  winsize size{};
  return ioctl(file, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : fallback;
}

std::string wrap(std::string_view text, std::size_t columns, std::size_t indent, std::size_t begin) {
  constexpr std::size_t kHang = 4;
  std::string wrapped;
  while (true) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    wrapped += wrapLine(line, columns, indent + (blanks > 0 ? blanks + kHang : 0), begin);
    if (line.size() == text.size())
      return wrapped;
    text.remove_prefix(line.size() + 1);
    wrapped += "\n" + std::string(text.starts_with('\n') ? 0 : indent, ' ');
    begin = indent;
  }
}

void useWrappedHelp(CLI::App &app) { app.formatter(std::make_shared<WrappedFormatter>()); }

std::string optionUsage(const CLI::Option &option) {
  const WrappedFormatter formatter;
  return formatter.make_option_name(&option, option.get_positional()) + formatter.make_option_opts(&option);
}

} // namespace voxc::tool
