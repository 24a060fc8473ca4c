// Sizes and times as the panel and the log tell them.
#pragma once

#include "view/Carving.h"
#include "view/Painter.h"

#include <string>

namespace voxc::view {

/// "512 x 215 x 315, 2281396 voxels, 13.17 MiB"; " in pages" behind it if they are.
std::string sizeText(const Model &model);
/// The same after edits.
std::string sizeText(const Model &model, const Carving &carving);

/// "320x180, 1 sample, 24 ms". Precondition: there is a picture.
std::string stepText(const Painting &painting);

/// "; 120 pages so far, 90 of them read ahead", of a scene in pages; else "".
std::string pagesText(const Painting &painting);

} // namespace voxc::view
