// Reading TIFF files from memory.
#include "Input/Dense/TiffFile.h"

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace voxc {

namespace {

TiffMemory &memoryOf(thandle_t handle) { return *static_cast<TiffMemory *>(handle); }

tmsize_t readBytes(thandle_t handle, void *target, tmsize_t size) {
  TiffMemory &memory = memoryOf(handle);
  const std::uint64_t left = memory.bytes.size() - std::min<std::uint64_t>(memory.at, memory.bytes.size());
  const auto count =
      static_cast<std::size_t>(std::min<std::uint64_t>(left, static_cast<std::uint64_t>(size)));
  if (count > 0)
    std::memcpy(target, memory.bytes.data() + memory.at, count);
  memory.at += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t writeNothing(thandle_t, void *, tmsize_t) { return -1; }

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  TiffMemory &memory = memoryOf(handle);
  const std::uint64_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? memory.at : memory.bytes.size();
  return memory.at = base + offset;
}

int closeNothing(thandle_t) { return 0; }
toff_t sizeOf(thandle_t handle) { return memoryOf(handle).bytes.size(); }

int mapBytes(thandle_t handle, void **base, toff_t *size) {
  // libtiff writes to no map of a file that it only reads.
  *base = const_cast<std::byte *>(memoryOf(handle).bytes.data());
  *size = memoryOf(handle).bytes.size();
  return 1;
}
void unmapNothing(thandle_t, void *, toff_t) {}

int keepProblem(TIFF *, void *data, const char *, const char *format, va_list arguments) {
  auto &memory = *static_cast<TiffMemory *>(data);
  std::array<char, 200> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  if (memory.problem.empty())
    memory.problem = text.data();
  return 1;
}
int ignoreWarning(TIFF *, void *, const char *, const char *, va_list) { return 1; }

} // namespace

TIFF *openTiff(TiffMemory &memory) {
  constexpr tmsize_t kMostAtOnce = tmsize_t{1} << 30;
  TIFFOpenOptions *const options = TIFFOpenOptionsAlloc();
  if (!options)
    return nullptr;
  TIFFOpenOptionsSetMaxSingleMemAlloc(options, kMostAtOnce);
  TIFFOpenOptionsSetErrorHandlerExtR(options, keepProblem, &memory);
  TIFFOpenOptionsSetWarningHandlerExtR(options, ignoreWarning, nullptr);
  TIFF *const tiff = TIFFClientOpenExt("slices", "r", &memory, readBytes, writeNothing, seek, closeNothing,
                                       sizeOf, mapBytes, unmapNothing, options);
  TIFFOpenOptionsFree(options);
  return tiff;
}

TiffPage tiffPage(TIFF *tiff) {
  TiffPage page;
  page.width = tiffTag<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
  page.height = tiffTag<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
  page.bits = tiffTag<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  page.samples = tiffTag<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  page.format = tiffTag<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  page.photometric = tiffTag<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  page.planar = tiffTag<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  std::uint16_t *kinds = nullptr;
  if (TIFFGetFieldDefaulted(tiff, TIFFTAG_EXTRASAMPLES, &page.extra, &kinds) == 1 && page.extra > 0 &&
      kinds) {
    page.isPremultiplied = kinds[0] == EXTRASAMPLE_ASSOCALPHA;
    page.hasAlpha = page.isPremultiplied || kinds[0] == EXTRASAMPLE_UNASSALPHA;
  }
  page.isTiled = TIFFIsTiled(tiff) != 0;
  return page;
}

bool isGrey(const TiffPage &page) {
  return (page.photometric == PHOTOMETRIC_MINISBLACK || page.photometric == PHOTOMETRIC_MINISWHITE) &&
         !page.hasAlpha && page.samples - page.extra <= 1;
}

namespace {

struct TiffType {
  std::uint16_t bits, format;
  SampleType type;
};

constexpr std::array<TiffType, 10> kTiffTypes{{{8, SAMPLEFORMAT_UINT, SampleType::Uint8},
                                               {8, SAMPLEFORMAT_INT, SampleType::Int8},
                                               {16, SAMPLEFORMAT_UINT, SampleType::Uint16},
                                               {16, SAMPLEFORMAT_INT, SampleType::Int16},
                                               {32, SAMPLEFORMAT_UINT, SampleType::Uint32},
                                               {32, SAMPLEFORMAT_INT, SampleType::Int32},
                                               {64, SAMPLEFORMAT_UINT, SampleType::Uint64},
                                               {64, SAMPLEFORMAT_INT, SampleType::Int64},
                                               {32, SAMPLEFORMAT_IEEEFP, SampleType::Float32},
                                               {64, SAMPLEFORMAT_IEEEFP, SampleType::Float64}}};

} // namespace

std::optional<SampleType> sampleTypeOf(const TiffPage &page) {
  if (page.bits == 1 || page.bits == 2 || page.bits == 4)
    return SampleType::Uint8;
  const std::uint16_t format = page.format == SAMPLEFORMAT_VOID ? SAMPLEFORMAT_UINT : page.format;
  for (const TiffType &row : kTiffTypes)
    if (row.bits == page.bits && row.format == format)
      return row.type;
  return std::nullopt;
}

bool isPlainColour(const TiffPage &page) {
  return page.samples > page.extra &&
         ((page.photometric == PHOTOMETRIC_RGB && page.samples - page.extra == 3) ||
          (page.photometric == PHOTOMETRIC_MINISBLACK && page.samples - page.extra == 1)) &&
         (page.bits == 8 || page.bits == 16) && page.format == SAMPLEFORMAT_UINT;
}

} // namespace voxc
