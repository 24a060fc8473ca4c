// The arithmetic of steps, and what a turn of the loop waits for.
#include "StepNames.h"

namespace voxc {
void addStepNames(TemplateNames &names, const Plan &plan) {
  auto &[holes, conditions] = names;
  const bool inDoubles = plan.steps == Steps::Float64;
  const bool inPackets = plan.packing == Packing::Packets;
  const std::string real3 = inDoubles ? "dvec3" : "vec3";
  holes["real"] = inDoubles ? "double" : "float";
  holes["real-name"] = inDoubles ? "doubles" : "float32";
  holes["real3"] = real3;
  conditions["doubles"] = inDoubles;
  conditions["by-bits"] = plan.compare == Compare::Bits;
  conditions["refines"] = plan.steps == Steps::Refined;
  conditions["packets"] = inPackets;
  conditions["narrow-packets"] = plan.packetWidth == PacketWidth::Narrow;
  conditions["exact"] = plan.isExact();
  conditions["ieee"] = plan.arithmetic == Arithmetic::Ieee;
  // Packets take such steps as they come, whether they settle or not.
  conditions["settles-in-walks"] = conditions["exact"] && conditions["ieee"] && !conditions["refines"];
  conditions["keeps-sums"] = true; // Of every language but that of WebGL.

  conditions["keeps-cell"] = plan.speculative;

  const bool tells = plan.gapFaces == GapFaces::Lookup;
  conditions["tells-faces"] = tells;
  holes["and-faces"] = tells ? ", inout " + real3 + " face" : "";
  holes["and-face"] = tells ? ", face" : "";
  holes["what-is-empty"] = tells ? "what is empty there with its faces ahead" : "what is empty there";
}

} // namespace voxc
