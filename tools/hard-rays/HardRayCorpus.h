// Single rays with their exact hits, as lines of text: what a corpus of regressions is made of.
#pragma once

#include "voxc/Support/Error.h"
#include "voxc/Support/Geometry.h"
#include "voxc/Trace/BoundedRay.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voxc::tool {

/// A ray, the scene that it is traced in, and its exact hit there.
struct CorpusRay {
  std::string scene; ///< One of `hardScenes`.
  Int3 extent;
  Ray ray;
  std::optional<RayBounds> bounds; ///< If it has some.
  Hit exact;
};

/// "SCENE WxHxD OX OY OZ DX DY DZ X Y Z RGBA T", with bounds "TMIN TMAX" before X: floats in hexadecimal, so
/// that no bit is lost.
std::string corpusLine(const CorpusRay &ray);
/// The hit's part of it: "X Y Z RGBA T".
std::string hitText(const Hit &hit);

/// Reads lines as `corpusLine` writes them; # starts a comment. Errors name `name` and the line.
Expected<std::vector<CorpusRay>> parseCorpus(std::string_view text, const std::string &name);

} // namespace voxc::tool
