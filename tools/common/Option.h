// An option of a command, or a word of it. CLI11 stands behind it; its header takes longer to compile than
// most of our files, so that few include it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace CLI {
class Option;
} // namespace CLI

namespace voxc::tool {

/// An option of a command, or a word that stands alone, such as INPUT. A handle: copies mean the same option,
/// and what returns one can be written in a chain.
class Option {
public:
  explicit Option(CLI::Option &option) : option_(&option) {}

  /// What its value is called in the help, such as FILE; "" for a word, which is called by its own name.
  Option takes(const std::string &value) const;
  /// In place of what the help said of it.
  Option text(const std::string &text) const;
  Option required(bool isRequired = true) const;
  /// The help tells its value of now, or `value`, as its default.
  Option showsDefault() const;
  Option showsDefault(const std::string &value) const;

  /// Refuses all other values.
  Option oneOf(const std::vector<std::string> &values) const;
  /// Takes any value; a shell offers these.
  Option suggests(const std::vector<std::string> &values) const;
  /// The values of `oneOf` or `suggests`; none without.
  std::vector<std::string> choices() const;
  /// Refuses numbers outside; both bounds are allowed. For int, unsigned, std::uint64_t, float and double.
  template <typename Number> Option between(Number least, Number most) const;
  Option positive() const;
  Option notNegative() const;
  /// Refuses "", as a shell writes a variable that was never set: of a name that need not be given.
  Option notEmpty() const;
  /// Refuses values of which `problemOf` says more than "": what is wrong, and what would be right.
  Option check(std::string (*problemOf)(const std::string &value)) const;

  /// Values are separated by commas, all in one word; it may be given several times too.
  Option list() const;
  /// A list of so many values, no more and no fewer.
  Option values(std::size_t count) const;
  /// It may be given several times, one value each; all are kept.
  Option repeated() const;
  /// It may be given several times; the last counts.
  Option lastCounts() const;
  Option needs(Option other) const;
  Option excludes(Option other) const;

  /// The first of its names, with its dashes; of a word its name.
  std::string name() const;
  /// All its names, with their dashes, the long ones first.
  std::vector<std::string> names() const;
  /// Does it go by this name, written with its dashes?
  bool isCalled(const std::string &name) const;
  std::string text() const;
  std::string group() const;
  /// What its value is called; see takes().
  std::string value() const;
  /// How the help shows it: its names, and what it takes.
  std::string usage() const;
  bool isRequired() const;
  /// Does it stand alone, without a name?
  bool isWord() const;
  /// A flag takes none.
  bool takesValue() const;
  /// Values that it was given; 0 after parsing if it was not.
  std::size_t count() const;
  /// These values, as they were written.
  std::vector<std::string> written() const;
  /// The words that give it these values again: "--bounds", "0,0,0,9,9,9". None if it was not given.
  std::vector<std::string> words() const;

private:
  friend class CommandLine;
  CLI::Option *option_;
};

} // namespace voxc::tool
