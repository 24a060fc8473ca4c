// The sections of the report, each as HTML; empty where there are no records for it. Their prose stands in
// report-runtime/section.
#pragma once

#include "report/Catalogue.h"
#include "report/Report.h"

#include <map>
#include <string>

namespace voxc::report {

/// Pictures of models by their name, as data: addresses.
using Pictures = std::map<std::string, std::string>;

/// What is compared, and how to read the charts.
std::string introductionSection(const Catalogue &catalogue);
/// For each model the verdict, its picture, its note and a chart for each stage.
std::string modelSections(const Catalogue &catalogue, const Pictures &pictures, const ModelNotes &notes);
/// Which formats are on the frontier of which models.
std::string frontierSection(const Catalogue &catalogue);
/// Speeds and sizes that a search foretold beside those that were measured.
std::string predictionSection(const Catalogue &catalogue);
/// How much smaller whole-level-dedup makes volumes.
std::string dedupSection(const Catalogue &catalogue);
/// How much faster restart-sv makes kernels.
std::string restartSection(const Catalogue &catalogue);
/// How much faster unroll-sv makes kernels.
std::string unrollSection(const Catalogue &catalogue);
/// What exact steps cost, and what float steps get wrong.
std::string precisionSection(const Catalogue &catalogue);
/// The largest memory of building each format.
std::string memorySection(const Catalogue &catalogue);
/// Cells that failed, and why.
std::string failureSection(const Catalogue &catalogue);
/// Every cell, in a table that can be sorted, with a link to the same as comma-separated values if they have
/// a name.
std::string cellSection(const Catalogue &catalogue, const std::string &csvName);
/// How it was measured, on what, and by which commands.
std::string methodSection(const Catalogue &catalogue);

/// The anchor of an entry's row in the table of cells, "r12".
std::string rowId(const Catalogue &catalogue, const Entry &entry);

} // namespace voxc::report
