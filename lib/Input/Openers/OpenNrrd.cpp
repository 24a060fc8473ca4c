// Opening NRRD volumes.
#include "Input/Openers/Openers.h"

#include "Input/Dense/NrrdData.h"
#include "Input/Dense/NrrdHeader.h"
#include "Input/Dense/Orientation.h"
#include "Input/Dense/VolumeChoice.h"
#include "Input/Openers/OpenDense.h"

#include <filesystem>
#include <utility>

namespace voxc {

namespace {

/// Bytes from the first sample to that of the volume that is asked for.
Expected<std::int64_t> offsetOf(const NrrdHeader &header, const InputOptions &options,
                                std::vector<std::string> &warnings) {
  std::uint64_t volumes = 1;
  for (const NrrdHeader::Others &axis : header.others)
    volumes *= axis.size;
  auto volume = VOXC_TRY(chooseVolume(volumes, options, warnings));
  std::int64_t offset = 0;
  for (const NrrdHeader::Others &axis : header.others) {
    offset += static_cast<std::int64_t>(volume % axis.size) * axis.step;
    volume /= axis.size;
  }
  return offset;
}

/// The steps, or none where samples lie without gaps, as they are read fastest.
std::array<std::int64_t, 3> stepsIfAny(const NrrdHeader &header) {
  const auto bytes = static_cast<std::int64_t>(byteSize(header.layout.type));
  const std::int64_t row = bytes * header.extent.x;
  const std::array<std::int64_t, 3> without{bytes, row, row * header.extent.y};
  const auto isSame = [&](int axis) {
    const auto i = static_cast<std::size_t>(axis);
    return header.steps[i] == without[i] || header.extent[axis] == 1;
  };
  return isSame(0) && isSame(1) && isSame(2) ? std::array<std::int64_t, 3>{} : header.steps;
}

Expected<DenseVolume> volumeOf(NrrdHeader &header, NrrdData data, std::int64_t offset) {
  DenseVolume volume;
  volume.extent = header.extent;
  volume.layout = header.layout;
  volume.samples = data.samples + offset;
  volume.storage = std::move(data.storage);
  volume.steps = stepsIfAny(header);
  volume.channels = header.channels;
  volume.channelStep = header.channelStep;
  volume.areLabels = header.areLabels;
  volume.sampleToModel = header.sampleToModel;
  volume.unit = header.unit;
  volume.warnings = std::move(header.warnings);
  volume.notes = std::move(header.notes);
  if (header.hasSpace)
    orient(volume, header.isLeftHanded);
  return volume;
}

Expected<DenseVolume> readVolume(const std::string &path, std::shared_ptr<const WatchedFile> file,
                                 const InputOptions &options) {
  std::string_view text = file->text();
  auto header = VOXC_TRY(readNrrdHeader(text, options.volume > 0));
  const auto offset = VOXC_TRY(offsetOf(header, options, header.warnings));
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  auto data =
      VOXC_TRY(readNrrdData(header, std::move(file), std::as_bytes(std::span(text)), folder, options));
  header.warnings.insert(header.warnings.end(), data.warnings.begin(), data.warnings.end());
  if (header.isUpZ && options.isAutomatic && !options.isUpKnown)
    header.notes.push_back("its +z goes to the head of a patient, and lies as voxel z; --up z turns it to "
                           "+y, the up of pictures, as it is for NIfTI files");
  auto volume = VOXC_TRY(volumeOf(header, std::move(data), offset));
  for (const std::string &name : header.dataFiles)
    volume.files.push_back((folder / name).string());
  return volume;
}

} // namespace

Expected<Input> openNrrd(const std::string &path, const InputOptions &options) {
  return openDense(path, "NRRD", options, [&](std::shared_ptr<const WatchedFile> file) {
    return readVolume(path, std::move(file), options);
  });
}

} // namespace voxc
