// The catalogue: cells with what all sections of the report need of them, and the stages on which formats
// compete.
#pragma once

#include "report/Cells.h"
#include "report/FormatLook.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace voxc::report {

/// What stands in place of passes where there are none.
inline constexpr const char *kNoPasses = "none";

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
  std::size_t format = 0; ///< The same for all entries of one format.
  std::string passes;     ///< "whole-level-dedup, restart-sv", or `kNoPasses`.
  std::string device;     ///< Short, and different for different devices.
  std::string column;     ///< The model, with the rays where it is traced by several.
  bool onFrontier = false;

  Figure bytes;     ///< Of the volume; more than 0.
  Figure peakBytes; ///< Of building it.
  double resolution = 0;
  std::optional<tool::bench::Speed> speed; ///< In what its device counts; of no absurd size.
  bool hasClock = false;                   ///< Its device counts its own timestamps, others CPU seconds.
  bool isSteady = true;
  std::optional<Errors> errors;

  bool hasPoint() const { return bytes && speed; }
  bool hasPass(std::string_view pass) const;
};

/// One competition: formats on the same model, rays, device, resolution and precision, with the same passes,
/// those that most formats were measured with.
struct Stage {
  std::string model, column, device, precision, passes;
  double resolution = 0;
  bool hasClock = false;
  std::vector<std::size_t> entries;
  std::size_t otherPasses = 0; ///< Cells of the same competition that had other passes.
};

struct Catalogue {
  std::vector<Entry> entries;       ///< In the order of the cells.
  std::vector<Stage> stages;        ///< Models in their order; in each, large resolutions first.
  std::vector<std::string> models;  ///< In the order in which they first came.
  std::vector<std::string> columns; ///< Likewise, of all entries.
  std::size_t formats = 0;
  std::vector<std::string> devices;
};

/// The cells must outlive the catalogue.
Catalogue makeCatalogue(const std::vector<Cell> &cells);

/// What a speed counts in: "Mrays/CPU s" or "Mrays/GPU s".
std::string speedUnit(bool hasClock);

} // namespace voxc::report
