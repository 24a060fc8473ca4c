// Reading the rows of a PLY file one after the other, each claim checked against the file's size first.
#pragma once

#include "Mesh/Ply/PlyHeader.h"
#include "voxc/Support/File.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc {

/// One row of an element, indexed like its properties. Every PLY type fits a double exactly.
struct PlyRow {
  std::vector<double> values;             ///< Scalars; the length of lists.
  std::vector<std::vector<double>> lists; ///< Contents of lists; empty for scalars.
};

/// An open PLY file.
class PlyReader {
public:
  /// Opens `path` and reads its header. Errors name the path.
  static Expected<PlyReader> open(const std::string &path);

  /// The same file again, from its first row on.
  Expected<PlyReader> reopened() const { return open(path_); }

  const PlyHeader &header() const { return header_; }
  /// The whole file, as it is mapped.
  std::span<const std::byte> bytes() const { return file_.bytes(); }
  /// What follows the rows that were read; at first what follows the header.
  std::string_view rest() const { return rest_; }

  /// Calls `visit(element, index, row)` for every row, in the order of the file, until it returns an error.
  /// Before the first row of an element, its count is known to fit into the rest of the file. Errors: a
  /// truncated file, a number that is not one, a list of negative length; they name the path.
  using Visit =
      std::function<Expected<void>(const PlyElement &element, std::uint64_t index, const PlyRow &row)>;
  Expected<void> readRows(const Visit &visit);

  /// Bytes behind the last row, of texts without blanks at their ends; once all rows are read.
  std::uint64_t bytesBehind() const;

  /// An error about this file.
  Error broken(const std::string &what) const;

private:
  PlyReader(std::string path, MappedFile file);

  Expected<void> readElement(const PlyElement &element, const Visit &visit);
  bool readRow(const PlyElement &element, PlyRow &row);
  bool readList(const PlyProperty &property, double length, std::vector<double> &list);
  bool readValue(PlyType type, double &value);
  bool readText(PlyType type, double &value);
  bool readBinary(PlyType type, double &value);
  /// How many values of `bytes` bytes could be in the rest of the file.
  std::uint64_t capacity(std::uint64_t bytes) const;
  /// Fewest bytes that a value takes.
  std::uint64_t leastSize(PlyType type) const;

  std::string path_;
  MappedFile file_;
  PlyHeader header_;
  std::string_view rest_; ///< What is not read yet.
};

} // namespace voxc
