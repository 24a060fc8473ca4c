// The record of words in the head of a .hvx file (docs/hvx.md): what each level takes.
#pragma once

#include "voxc/Volume/Volume.h"

#include <string>
#include <string_view>

namespace voxc {

/// The provenance and, on a line of its own behind it, the record. All records of a format have the same
/// length, so that the head of a volume can be laid out before its words are counted.
std::string textWithRecord(const VolumeInfo &info);

/// Takes such a text apart, into `info.provenance` and `info.wordCounts`. What does not look like the record
/// of so many levels is provenance.
void readRecord(std::string_view text, VolumeInfo &info);

} // namespace voxc
