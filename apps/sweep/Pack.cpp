// Writing packs.
#include "sweep/Pack.h"

#include "sweep/SampleCheck.h"

#include "common/Files.h"
#include "options/Outputs.h"
#include "voxc/IR/Query.h"
#include "voxc/Kernel/Compile.h"
#include "voxc/Measure/Digest.h"
#include "voxc/Passes/Pass.h"
#include "voxc/Support/EmbeddedFile.h"
#include "voxc/Support/File.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace voxc {

std::span<const EmbeddedFile> benchFiles();

namespace tool::bench {

namespace {

constexpr const char *kScript = "run.sh", *kCells = "cells.txt";

std::string numbered(const char *format, unsigned number) {
  char text[32];
  std::snprintf(text, sizeof text, format, number);
  return text;
}

std::string_view script() { return benchFiles().front().text; }

/// The kernel's module as bytes.
Expected<std::string> kernelBytes(const Record &record, const Format &format) {
  const bool isLarge = record.volume.words.value_or(0) > kSegmentWords;
  auto kernel =
      VOXC_TRY(compileKernel(format, {.addressing = isLarge ? Addressing::Segments : Addressing::Buffer}));
  return std::string(reinterpret_cast<const char *>(kernel.spirv.data()),
                     kernel.spirv.size() * sizeof(std::uint32_t));
}

bool isDigest(const std::string &text) {
  return text.size() == 16 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string sizeOf(const RaysPart &rays) {
  return rays.size ? std::to_string((*rays.size)[0]) + "x" + std::to_string((*rays.size)[1]) : "-";
}

} // namespace

std::string PackWriter::pathOf(const std::string &name) const {
  return (std::filesystem::path(folder_) / numbered("pack-%03u", pack_) / name).string();
}

Expected<void> PackWriter::startPack() {
  constexpr unsigned kMostPacks = 999; // Their names are read in order.
  if (pack_ == kMostPacks)
    return Error::usage("the packs would be more than 999; --pack-megabytes allows larger ones");
  ++pack_;
  // The list of cells and the script may come into any pack.
  left_ = packBytes_ - std::min<std::uint64_t>(packBytes_, cells_.size() + script().size());
  return makeOutputFolder(pathOf(""));
}

Expected<void> PackWriter::addWhole(const std::string &name, std::string_view content) {
  if (!added_.insert(name).second)
    return {};
  if (pack_ == 0 || left_ < content.size())
    VOXC_TRY(startPack());
  left_ -= std::min<std::uint64_t>(left_, content.size());
  return writeText(pathOf(name), content);
}

Expected<void> PackWriter::addPieces(const std::string &name, const std::string &path) {
  if (!added_.insert(name).second)
    return {};
  const auto file = VOXC_TRY(MappedFile::open(path));
  auto bytes = file.bytes();
  for (unsigned piece = 1; piece == 1 || !bytes.empty(); ++piece) {
    if (pack_ == 0 || left_ == 0)
      VOXC_TRY(startPack());
    const auto part = bytes.first(std::min<std::uint64_t>(bytes.size(), left_));
    VOXC_TRY(writeBytes(pathOf(name + numbered(".%03u", piece)), part));
    bytes = bytes.subspan(part.size());
    left_ -= part.size();
  }
  return {};
}

Expected<void> PackWriter::finish() {
  if (left_ < cells_.size() + script().size())
    VOXC_TRY(startPack());
  VOXC_TRY(writeText(pathOf(kCells), cells_));
  return writeText(pathOf(kScript), script());
}

Expected<Format> formatOf(const Record &record) {
  auto format = VOXC_TRY(parseFormat(record.format.name));
  VOXC_TRY(runPasses(format, record.format.passes));
  askForPrecision(format, record.precision);
  if (Digest().add(printIr(format)).hex() != record.format.digest)
    return Error::input("the format of cell " + record.cell + ", " + record.format.name +
                        ", is not the one that was measured: it was given as IR, or passes have changed");
  return format;
}

std::string cachePath(const std::string &folder, const std::string &modelDigest, const Format &format) {
  const std::string key = Digest().add(modelDigest).add(printIr(storageFormat(format))).hex();
  return (std::filesystem::path(folder) / "cache" / key).string();
}

Expected<void> packCell(const Record &record, const std::string &folder, PackWriter &packs) {
  // They become names of files and words of a script.
  if (!isDigest(record.cell) || !isDigest(record.rays.digest))
    return Error::input("cell '" + record.cell + "' or its rays have a digest that is not 16 hex digits");
  if (record.rays.order && record.rays.order != "given" && record.rays.order != "binned")
    return Error::input("cell '" + record.cell + "' has rays in the order '" + *record.rays.order +
                        "'; it should be given or binned");
  const auto format = VOXC_TRY(formatOf(record));
  const std::string stem = cachePath(folder, record.model.digest, format);
  const std::string key = std::filesystem::path(stem).filename().string();
  VOXC_TRY(packs.addPieces(key + ".hvx", stem + ".hvx"));
  const auto kernel = VOXC_TRY(kernelBytes(record, format));
  VOXC_TRY(packs.addWhole(record.format.digest + ".spv.001", kernel));

  const std::string rays = rayFileName(record.rays);
  if (!rays.empty())
    VOXC_TRY(packs.addPieces(rays, folder + "/cache/" + rays));
  const auto sample = VOXC_TRY(packedSample(record, folder));
  const auto bytes = std::as_bytes(std::span(sample));
  const std::string_view content{reinterpret_cast<const char *>(bytes.data()), bytes.size()};
  VOXC_TRY(packs.addWhole(sampleName(record) + ".001", content));
  const std::string order = record.rays.order.value_or(kAutoOrder);
  packs.addCell(record.cell + " " + key + " " + record.format.digest + " " + kindOf(record.rays) + " " +
                record.rays.digest + " " + sizeOf(record.rays) + " " + sampleName(record) + " " + order);
  return {};
}

} // namespace tool::bench

} // namespace voxc
