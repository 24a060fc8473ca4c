// A name that handlers of signals may read.
#include "Signature.h"

#include <cstdio>

namespace voxc::tool {
namespace {

char name[32] = "voxc";

} // namespace

const char *signature() { return name; }

void signAs(const char *program) { std::snprintf(name, sizeof name, "%s", program); }

} // namespace voxc::tool
