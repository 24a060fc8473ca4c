// Volumes as grids of OpenVDB. OpenVDB throws; nothing of that leaves this file.
#include "voxc/OpenVdb/OpenVdb.h"

#include "voxc/Support/File.h"

#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include <exception>
#include <ostream>
#include <streambuf>
#include <string>

namespace voxc {

namespace {

/// What OpenVDB writes, on its way to a file that has no name until it is whole.
class FileBuffer final : public std::streambuf {
public:
  explicit FileBuffer(OutputFile &file) : file_(file) {}

  const Expected<void> &result() const { return result_; }

protected:
  std::streamsize xsputn(const char *bytes, std::streamsize count) override {
    if (result_)
      result_ = file_.write(bytes, static_cast<std::size_t>(count));
    return result_ ? count : 0;
  }

  int_type overflow(int_type letter) override {
    const char byte = traits_type::to_char_type(letter);
    return xsputn(&byte, 1) == 1 ? traits_type::not_eof(letter) : traits_type::eof();
  }

private:
  OutputFile &file_;
  Expected<void> result_;
};

/// From index space, in which whole numbers are the middles of voxels. OpenVDB's matrices are applied from
/// the right.
openvdb::math::Transform::Ptr transformOf(const Transform &voxelToModel) {
  const glm::dvec3 origin = voxelToModel * glm::dvec4(0.5, 0.5, 0.5, 1);
  openvdb::Mat4R matrix = openvdb::Mat4R::identity();
  for (int row = 0; row < 3; ++row) {
    for (int axis = 0; axis < 3; ++axis)
      matrix(axis, row) = voxelToModel[axis][row];
    matrix(3, row) = origin[row];
  }
  return openvdb::math::Transform::createLinearTransform(matrix);
}

openvdb::Vec3s colourOf(std::uint32_t word) {
  const auto channel = [&](int shift) { return static_cast<float>(word >> shift & 255) / 255; };
  return {channel(0), channel(8), channel(16)};
}

Expected<openvdb::GridPtrVec> gridsOf(const Volume &volume, const Progress &progress) {
  const auto density = openvdb::FloatGrid::create(0);
  density->setName("density");
  density->setGridClass(openvdb::GRID_FOG_VOLUME);
  const auto colour = openvdb::Vec3SGrid::create(openvdb::Vec3s(0));
  colour->setName("Cd");
  for (const openvdb::GridBase::Ptr &grid : openvdb::GridPtrVec{density, colour})
    grid->setTransform(transformOf(volume.info().voxelToModel));
  const Int3 extent = volume.info().extent;
  const auto fill = [&](const Cube &cube, std::uint32_t word) {
    const auto side = static_cast<std::int32_t>(cube.side());
    openvdb::CoordBBox box = openvdb::CoordBBox::createCube({cube.low.x, cube.low.y, cube.low.z}, side);
    // A file that lies about its extent may have voxels outside.
    box.intersect({{0, 0, 0}, {extent.x - 1, extent.y - 1, extent.z - 1}});
    if (!box.empty()) {
      density->sparseFill(box, 1.0F);
      colour->sparseFill(box, colourOf(word));
    }
    return true;
  };
  VOXC_TRY(decode(volume, fill, progress));
  return openvdb::GridPtrVec{density, colour};
}

Expected<void> writeVdb(const Volume &volume, const std::string &path, const ExportOptions &options) {
  auto file = VOXC_TRY(OutputFile::create(path));
  try {
    openvdb::initialize();
    const auto grids = VOXC_TRY(gridsOf(volume, options.save.progress));
    FileBuffer buffer(file);
    std::ostream stream(&buffer);
    openvdb::io::Stream(stream).write(grids);
    if (!buffer.result())
      return buffer.result();
  } catch (const std::bad_alloc &) {
    return Error::environment("out of memory for '" + path + "'");
  } catch (const std::exception &problem) {
    return Error::environment("'" + path + "' cannot be written: " + problem.what());
  }
  return file.commit();
}

} // namespace

OtherExport openVdbExport() { return {".vdb", writeVdb}; }

} // namespace voxc
