// What the tables of passes, level kinds and attributes say, as text; docs/ has each to the letter.
#pragma once

#include <string>

namespace voxc::tool {

/// The passes of both IRs by their names, with their options.
std::string listPasses();

/// Each pass with its paragraph.
std::string describePasses();

/// The passes over plans, as a table in Markdown.
std::string describePlanPasses();

/// Each level kind with its parameters and attributes, and the attributes of a format.
std::string describeLevels();

/// Every attribute, as a table in Markdown.
std::string describeAttributes();

} // namespace voxc::tool
