// Words, lines and numbers of text files.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace voxc {

/// What may stand before a text in UTF-8.
constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";

/// Takes the next word off the front of `text`; empty if there is none.
std::string_view takeWord(std::string_view &text);

/// `text` without blanks at its ends.
std::string_view trimmed(std::string_view text);

/// `text` with small letters for its capital ones.
std::string lowerCase(std::string_view text);

/// `text` with a question mark for each control character: messages are of one line, and go to terminals.
std::string printable(std::string_view text);

/// "1 point" or "2 points", of a word that takes an s; and "1 point is" or "2 points are".
std::string counted(std::uint64_t count, std::string_view noun);
std::string countedAre(std::uint64_t count, std::string_view noun);

/// A decimal number, with a sign or without; infinite if it is too large for a double, and also for "inf" and
/// "nan", as some programs write them.
std::optional<double> parseNumber(std::string_view word);

/// A whole number.
std::optional<std::int64_t> parseInteger(std::string_view word);

/// "UTF-16" or "UTF-32" if the first characters of `text` are ASCII in that encoding, with a mark of the byte
/// order or without; else empty. Two characters are needed.
std::string_view wideEncoding(std::string_view text);

/// The sentence that says so of a file.
std::string isWideText(std::string_view encoding);

/// Lines of a text, which end by a line feed, a carriage return or both. A backslash at the end of a line
/// joins it with the next.
class TextLines {
public:
  /// A mark of UTF-8 at the beginning is passed over.
  explicit TextLines(std::string_view text) : text_(text), rest_(text) {
    if (rest_.starts_with(kByteOrderMark))
      rest_.remove_prefix(kByteOrderMark.size());
  }

  /// The next line, without its end; valid until the next call.
  std::optional<std::string_view> next();
  /// The number of the line that `next` gave, from 1; of joined lines the last.
  std::uint64_t number() const { return number_; }
  /// Bytes that have been read.
  std::uint64_t done() const { return text_.size() - rest_.size(); }

private:
  std::string_view takeLine();

  std::string_view text_;
  std::string_view rest_;
  std::size_t lineFeed_ = 0; ///< Where the next is in the text, if it is not behind.
  std::uint64_t number_ = 0;
  std::string joined_;
};

} // namespace voxc
