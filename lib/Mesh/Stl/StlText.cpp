// Words of a text .stl, one after the other: lines mean nothing but where a name ends.
#include "Mesh/Stl/StlText.h"

#include "Support/Text.h"

#include <algorithm>
#include <string>
#include <vector>

namespace voxc {

namespace {

class TextReader {
public:
  TextReader(const MeshInput &input, ScratchArray<StlTextCorner> &corners, Problem &problem)
      : input_(input), corners_(corners), problem_(problem), text_(input.file->text()), rest_(text_) {
    if (rest_.starts_with(kByteOrderMark))
      rest_.remove_prefix(kByteOrderMark.size());
  }

  void read() {
    for (std::uint64_t words = 0; !problem_; ++words) {
      if (words % 4096 == 0 && !input_.at(text_.size() - rest_.size(), text_.size()))
        return problem_.set(Error::interrupted());
      const std::string_view word = takeWord(rest_);
      if (word.empty())
        break;
      readStatement(lowerCase(word.substr(0, kLongestWord)));
    }
    if (!problem_ && isInside_)
      wrong("it ends inside a facet");
    if (!problem_)
      checkClosed();
  }

private:
  static constexpr std::size_t kLongestWord = 16;

  struct Statement {
    std::string_view word;
    void (TextReader::*read)();
  };

  void readStatement(const std::string &word) {
    static constexpr std::array<Statement, 7> kStatements{{{"vertex", &TextReader::readVertex},
                                                           {"facet", &TextReader::beginFacet},
                                                           {"outer", &TextReader::skipWord},
                                                           {"endloop", &TextReader::endLoop},
                                                           {"endfacet", &TextReader::endFacet},
                                                           {"solid", &TextReader::skipLine},
                                                           {"endsolid", &TextReader::skipLine}}};
    const auto *statement = std::find_if(kStatements.begin(), kStatements.end(),
                                         [&](const Statement &s) { return s.word == word; });
    if (statement == kStatements.end() && (word[0] == ';' || word[0] == '#' || word.starts_with("//")))
      wrong("'" + word + "' begins a comment, which STL does not have; take comments out");
    else if (statement == kStatements.end())
      wrong("'" + word + "' stands where a facet or its end should");
    else
      (this->*statement->read)();
  }

  void readVertex() {
    StlTextCorner corner;
    for (double &coordinate : corner) {
      const auto number = parseNumber(takeWord(rest_));
      if (!number)
        return wrong("a vertex lacks one of its three numbers");
      coordinate = *number;
    }
    loop_.push_back(corner);
  }

  /// "normal" and three numbers, which mean nothing.
  void beginFacet() {
    checkClosed();
    isInside_ = true;
    for (int i = 0; i < 4; ++i)
      takeWord(rest_);
  }

  void endFacet() {
    checkClosed();
    isInside_ = false;
  }

  void checkClosed() {
    if (!loop_.empty())
      wrong("a loop of " + std::to_string(loop_.size()) + " vertices is not closed by endloop");
  }

  void endLoop() {
    if (loop_.size() < 3)
      wrong("a loop has " + std::to_string(loop_.size()) + " vertices, fewer than three");
    if (!problem_)
      for (const PolygonCutter::Corners &triangle : cutter_.cut(loop_))
        for (const std::uint32_t corner : triangle)
          problem_.check(corners_.push(loop_[corner]));
    loop_.clear();
  }

  void skipWord() { takeWord(rest_); }

  void skipLine() { rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size())); }

  void wrong(const std::string &what) {
    const std::string_view done = text_.substr(0, text_.size() - rest_.size());
    const char end = text_.find('\n') == std::string_view::npos ? '\r' : '\n';
    problem_.set("line " + std::to_string(std::count(done.begin(), done.end(), end) + 1) + ": " + what);
  }

  const MeshInput &input_;
  ScratchArray<StlTextCorner> &corners_;
  Problem &problem_;
  std::string_view text_;
  std::string_view rest_;
  bool isInside_ = false;
  std::vector<StlTextCorner> loop_;
  PolygonCutter cutter_;
};

} // namespace

void readStlText(const MeshInput &input, ScratchArray<StlTextCorner> &corners, Problem &problem) {
  TextReader(input, corners, problem).read();
}

} // namespace voxc
