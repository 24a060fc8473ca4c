// A small scene for the tests of the viewer, traced by the oracle.
#pragma once

#include "view/FormatText.h"
#include "view/Scene.h"
#include "voxc/Construct/Constructor.h"
#include "voxc/Oracle/Oracle.h"
#include "voxc/Source/Sources.h"

#include <memory>

namespace voxc::view {

/// Traces by the oracle, which needs no kernel.
class OracleTracer final : public Tracer {
public:
  explicit OracleTracer(std::shared_ptr<const Volume> volume)
      : volume_(std::move(volume)), oracle_(*Oracle::of(*volume_)) {}

  Expected<TraceReport> trace(RaySpan rays, std::span<Hit> hits, const TraceOptions &options) override {
    if (options.progress.stopped())
      return Error::interrupted();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      hits[i] = oracle_.trace(rays[i]);
      hits[i].steps = options.countSteps ? 7 : 0;
    }
    return TraceReport{};
  }

private:
  std::shared_ptr<const Volume> volume_;
  Oracle oracle_;
};

/// The terrain with 16 voxels a side in any format that holds it, on the devices "cpu" and "other".
inline SceneMaker hillMaker() {
  SceneMaker maker;
  maker.makeModel = [](const std::string &text, const Progress &) -> Expected<Model> {
    const std::string format = text.empty() ? "R(4^3)" : text;
    auto source = *makeBuiltinSource("terrain", 16);
    Expected<Format> parsed = readFormatText(parseFormatText(format));
    if (!parsed)
      return parsed.error();
    Expected<Built> built = Constructor::compile(*parsed)->build(*source);
    if (!built)
      return built.error();
    return Model{std::make_shared<const Volume>(std::move(built->volume)), *parsed, spelledText(format)};
  };
  maker.makeTracers = [](const Model &model, std::string &device) -> Expected<Tracers> {
    if (device == "broken")
      return Error::environment("there is no such device");
    device = device.empty() ? "cpu" : device;
    return Tracers{std::make_unique<OracleTracer>(model.volume)};
  };
  return maker;
}

inline std::shared_ptr<Scene> makeHill() { return *makeScene(hillMaker(), {}, nullptr, {}); }

} // namespace voxc::view
