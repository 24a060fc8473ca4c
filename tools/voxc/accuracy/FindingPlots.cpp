// Findings as plots.
#include "accuracy/Findings.h"

#include "common/Files.h"
#include "plot/Plot.h"

#include <cstdio>
#include <filesystem>

namespace voxc::tool {
namespace {

constexpr const char *kSpeedLabel = "million rays per CPU second";
constexpr const char *kErrorLabel = "rays missed, ghost or wrong, per million";

std::string note(const std::string &label, double speed, double errors) {
  char text[128];
  std::snprintf(text, sizeof text, ": %.4g million rays per CPU second, %.4g errors per million", speed,
                errors);
  return label + text;
}

/// Errors per million where one ray of those checked is wrong.
double leastError(const ErrorFigures &error) {
  return error.rays == 0 ? 1 : 1e6 / static_cast<double>(error.rays);
}

plot::Plot variantsPlot(const Findings &findings) {
  const std::vector<std::string> names = labels(findings);
  plot::Plot plot{
      "Speed against error", findings.subject, {kSpeedLabel}, {kErrorLabel, plot::Spacing::Decades}, {}};
  plot.y.least = leastError(findings.contestants[0]->error);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double speed = mraysPerCpuSecond(*findings.contestants[i]);
    const double errors = errorsPerMillion(findings.contestants[i]->error);
    plot.series.push_back({names[i], {{speed, errors, note(names[i], speed, errors)}}});
  }
  return plot;
}

plot::Plot lodPlot(const Findings &findings) {
  plot::Plot plot{"Speed of deliberate approximation",
                  findings.subject,
                  {"speed-up against full detail"},
                  {"PSNR against full detail in dB"},
                  {}};
  for (const LodFinding &lod : findings.lods) {
    char label[32];
    std::snprintf(label, sizeof label, "%g %s", lod.pixels, lod.pixels == 1 ? "pixel" : "pixels");
    plot.series.push_back({label, {{lod.speedUp, lod.picture.psnr, label}}});
  }
  return plot;
}

/// A line for each variant; `value` takes what is plotted from a score.
plot::Plot seriesPlot(const std::vector<SeriesPoint> &series, const std::vector<std::string> &names,
                      plot::Plot plot, double (*value)(const Score &score)) {
  plot.connected = true;
  for (std::size_t i = 0; i < names.size(); ++i) {
    plot::Series line{names[i], {}};
    for (const SeriesPoint &point : series) {
      const Score &score = point.scores[i];
      line.points.push_back(
          {point.at, value(score), note(names[i], score.mraysPerCpuSecond, errorsPerMillion(score.error))});
    }
    plot.series.push_back(std::move(line));
  }
  return plot;
}

class PlotWriter {
public:
  explicit PlotWriter(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void write(const std::string &name, const plot::Plot &plot) {
    if (result_)
      result_ = writeText((folder_ / (name + ".svg")).string(), plot::toSvg(plot));
  }

  void writeSeries(const std::string &name, const std::string &title, const plot::Axis &x,
                   const std::vector<SeriesPoint> &series, const std::vector<std::string> &names) {
    if (series.empty())
      return;
    const ErrorFigures &error = series.front().scores.front().error;
    const std::string subtitle = std::to_string(error.rays) + " rays at each place";
    write(name + "-error", seriesPlot(series, names,
                                      {"Error against " + title,
                                       subtitle,
                                       x,
                                       {kErrorLabel, plot::Spacing::Decades, leastError(error)},
                                       {}},
                                      [](const Score &score) { return errorsPerMillion(score.error); }));
    write(name + "-speed",
          seriesPlot(series, names, {"Speed against " + title, subtitle, x, {kSpeedLabel}, {}},
                     [](const Score &score) { return score.mraysPerCpuSecond; }));
  }

  Expected<void> result() { return result_; }

private:
  std::filesystem::path folder_;
  Expected<void> result_;
};

} // namespace

Expected<void> writePlots(const Findings &findings, const std::string &folder) {
  const std::vector<std::string> names = labels(findings);
  PlotWriter writer(folder);
  writer.write("accuracy", variantsPlot(findings));
  if (!findings.lods.empty())
    writer.write("lod", lodPlot(findings));
  writer.writeSeries("distance", "the distance of the origin",
                     {"distance of the origin in voxels", plot::Spacing::Decades}, findings.distances, names);
  writer.writeSeries("resolution", "resolution", {"voxels an axis", plot::Spacing::Octaves},
                     findings.resolutions, names);
  return writer.result();
}

} // namespace voxc::tool
