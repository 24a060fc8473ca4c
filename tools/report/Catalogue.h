// The catalogue: cells with what all sections of the report need of them, and the stages on which formats
// compete.
#pragma once

#include "report/Cells.h"
#include "report/FormatLook.h"
#include "report/Pareto.h"
#include "report/PassNames.h"
#include "report/SearchVerdict.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace voxc::report {

/// Rays checked against the exact oracle, and those of them that differ.
struct Errors {
  double rays = 0, missed = 0, ghost = 0, wrong = 0;

  double sum() const { return missed + ghost + wrong; }
};

/// A figure that a record may lack.
using Figure = std::optional<double>;

struct Entry {
  const Cell *cell = nullptr;
  FormatLook look;
  std::string name; ///< Of the format, and of the passes in which it differs from most: "G(8) +restart-sv".
  std::size_t variant = 0; ///< The same for all entries of one format with the same passes.
  std::string device;      ///< Short, and different for different devices.
  std::string column;      ///< The model, with the rays where it is traced by several.
  Standing standing;       ///< In its stage; the rival is an index into the entries.

  Figure bytes;     ///< Of the volume; more than 0.
  Figure peakBytes; ///< Of building it.
  double resolution = 0;
  std::optional<tool::bench::Speed> speed; ///< In what its device counts; of no absurd size, and in order.
  bool hasClock = false;                   ///< Its device counts its own timestamps, others CPU seconds.
  bool isSteady = true;
  std::optional<Errors> errors;

  bool hasPoint() const { return bytes && speed; }
  bool isLeading() const { return hasPoint() && standing.place == Place::Leading; }
  bool isAsGood() const { return hasPoint() && standing.place == Place::AsGood; }
  bool hasPass(std::string_view pass) const;
};

/// One competition: formats, each with its passes, on the same model, rays, device, resolution and precision.
struct Stage {
  std::string model, column, device, precision;
  double resolution = 0;
  bool hasClock = false;
  std::vector<std::size_t> entries;
  Passes usualPasses;          ///< Those of most cells of this resolution, which names do not say.
  bool hasOtherPasses = false; ///< Some of its cells have others.
};

struct Catalogue {
  std::vector<Entry> entries;       ///< In the order of the cells.
  std::vector<Stage> stages;        ///< Models in their order; in each, large resolutions first.
  std::vector<std::string> models;  ///< In the order in which they first came.
  std::vector<std::string> columns; ///< Likewise, of all entries.
  std::size_t formats = 0;
  std::vector<std::string> devices;
  std::vector<SearchVerdict> verdicts; ///< Of what searches measured.

  /// The verdict that a stage's cells are in; null if they are of no search.
  const SearchVerdict *verdictOn(const Stage &stage) const;
};

/// The cells must outlive the catalogue; `verdicts` are on some of them.
Catalogue makeCatalogue(const std::vector<Cell> &cells, std::vector<SearchVerdict> verdicts = {});

/// What a speed counts in: "Mrays/CPU s" or "Mrays/GPU s".
std::string speedUnit(bool hasClock);

} // namespace voxc::report
