// The arithmetic of steps, and what a turn of the loop waits for.
#include "StepNames.h"

namespace voxc {
namespace {

/// True if the loop goes on at once with the cell that a step leads to, and looks back if the step was not
/// sure.
bool keepsCell(const Plan &plan) { return plan.walk == Walk::Direct && plan.precision == Precision::Exact; }

/// True if each level makes the faces of what it finds empty. Packets make them once for all levels: there,
/// what counts is how much is done, and not how long a turn waits for what it reads.
bool tellsFaces(const Plan &plan) { return plan.packing != Packing::Packets; }

} // namespace

void addStepNames(TemplateNames &names, const Plan &plan) {
  auto &[holes, conditions] = names;
  const bool inDoubles = plan.steps == Steps::Float64;
  const bool inPackets = plan.packing == Packing::Packets;
  const std::string real3 = inDoubles ? "dvec3" : "vec3";
  holes["real"] = inDoubles ? "double" : "float";
  holes["real-name"] = inDoubles ? "doubles" : "float32";
  holes["real3"] = real3;
  holes["real3-wide"] = inDoubles ? real3 : real3 + " ";
  conditions["doubles"] = inDoubles;
  conditions["by-bits"] = !inDoubles && !inPackets;
  conditions["refines"] = plan.steps == Steps::Refined;
  conditions["packets"] = inPackets;
  conditions["narrow-packets"] = plan.walk == Walk::Nested && plan.layout.strata.size() > 1;
  conditions["exact"] = plan.precision == Precision::Exact;
  conditions["ieee"] = plan.arithmetic == Arithmetic::Ieee;
  conditions["keeps-sums"] = true; // Of every language but that of WebGL.

  conditions["keeps-cell"] = keepsCell(plan);
  holes["and-is-closed"] = keepsCell(plan) ? " && walk.open == CLOSED" : "";

  const bool tells = tellsFaces(plan);
  conditions["tells-faces"] = tells;
  holes["and-faces"] = tells ? ", inout " + real3 + " face" : "";
  holes["and-face"] = tells ? ", face" : "";
  holes["what-is-empty"] = tells ? "what is empty there with its faces ahead" : "what is empty there";
}

} // namespace voxc
