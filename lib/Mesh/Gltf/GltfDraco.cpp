// Decoding through Draco. It throws where memory runs out; nothing of that leaves this file.
#include "Mesh/Gltf/GltfDraco.h"

#include <draco/compression/decode.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <string_view>

namespace voxc {

namespace {

using Type = AttributeView::Type;

/// What the head of compressed data claims, which Draco takes memory for before it looks at the rest.
struct DracoClaims {
  std::uint64_t faces = 0;
  std::uint64_t points = 0;
};

/// Reads a head of version 2.2, the only one that glTF has.
class DracoHead {
public:
  explicit DracoHead(std::span<const std::byte> bytes) : rest_(bytes) {}

  /// Nothing if it is no mesh of that version without metadata.
  std::optional<DracoClaims> read() {
    constexpr std::string_view kSign = "DRACO";
    constexpr std::uint64_t kMesh = 1;
    constexpr std::uint64_t kMetadata = 0x8000;
    for (const char letter : kSign)
      if (byte() != static_cast<unsigned char>(letter))
        return std::nullopt;
    const std::uint64_t major = byte();
    const std::uint64_t minor = byte();
    const std::uint64_t type = byte();
    const bool isEdgebreaker = byte() == 1;
    const std::uint64_t low = byte();
    const std::uint64_t flags = low | byte() << 8;
    if (major != 2 || minor != 2 || type != kMesh || (flags & kMetadata) != 0)
      return std::nullopt;
    DracoClaims claims;
    if (isEdgebreaker)
      byte(); // How the corners are walked.
    claims.points = number();
    claims.faces = number();
    if (!isEdgebreaker)
      std::swap(claims.points, claims.faces);
    return isShort_ ? std::nullopt : std::optional(claims);
  }

private:
  std::uint64_t byte() {
    isShort_ |= rest_.empty();
    if (rest_.empty())
      return 0;
    const auto value = std::to_integer<std::uint64_t>(rest_.front());
    rest_ = rest_.subspan(1);
    return value;
  }

  /// Seven bits a byte, the lowest first.
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 35; shift += 7) {
      const std::uint64_t next = byte();
      value |= (next & 127) << shift;
      if (next < 128)
        return value;
    }
    isShort_ = true;
    return 0;
  }

  std::span<const std::byte> rest_;
  bool isShort_ = false;
};

/// About what Draco keeps for a face and its corners.
constexpr std::uint64_t kBytesAFace = 160;
/// Of a flat grid a byte of connectivity and attributes holds hundreds.
constexpr std::uint64_t kMostFacesAByte = 1024;

bool isPlausible(const DracoClaims &claims, std::uint64_t bytes, std::uint64_t memory) {
  const std::uint64_t most = std::min(kMostFacesAByte * bytes, memory / kBytesAFace);
  return claims.faces <= most && claims.points <= 3 * most;
}

std::optional<Type> typeOf(draco::DataType type) {
  switch (type) {
  case draco::DT_INT8:
    return Type::Int8;
  case draco::DT_UINT8:
    return Type::Uint8;
  case draco::DT_INT16:
    return Type::Int16;
  case draco::DT_UINT16:
    return Type::Uint16;
  case draco::DT_FLOAT32:
    return Type::Float32;
  default:
    return std::nullopt;
  }
}

const draco::Mesh &meshOf(const std::shared_ptr<const void> &mesh) {
  return *static_cast<const draco::Mesh *>(mesh.get());
}

/// Rows of all points, written out: what the library keeps is shared between points.
Expected<void> copyRows(const draco::PointAttribute &attribute, std::uint32_t points,
                        ScratchArray<std::byte> &rows) {
  const auto bytes = static_cast<std::uint64_t>(attribute.byte_stride());
  const bool isMapped = attribute.is_mapping_identity() || attribute.indices_map_size() >= points;
  if (!isMapped || bytes == 0)
    return Error::input("has data whose attributes point nowhere");
  VOXC_TRY(rows.resize(points * bytes));
  for (std::uint32_t point = 0; point < points; ++point) {
    const auto at = attribute.mapped_index(draco::PointIndex(point));
    if (at.value() >= attribute.size() || !attribute.IsAddressValid(attribute.GetAddress(at) + bytes - 1))
      return Error::input("has data whose attributes point nowhere");
    std::memcpy(rows.data() + point * bytes, attribute.GetAddress(at), bytes);
  }
  return {};
}

Expected<void> copyIndices(const draco::Mesh &mesh, ScratchArray<std::uint32_t> &indices) {
  VOXC_TRY(indices.resize(std::uint64_t{3} * mesh.num_faces()));
  for (std::uint32_t face = 0; face < mesh.num_faces(); ++face)
    for (std::uint32_t corner = 0; corner < 3; ++corner)
      indices[std::uint64_t{3} * face + corner] = mesh.face(draco::FaceIndex(face))[corner].value();
  return {};
}

} // namespace

std::optional<DracoMesh> DracoMesh::decode(GltfContext &context, GltfBuffers &buffers,
                                           const GltfObject &draco) {
  const auto view = draco.index("bufferView", buffers.views());
  if (!view) {
    draco.problem("has no buffer view");
    return std::nullopt;
  }
  const std::span<const std::byte> bytes = buffers.view(*view).bytes;
  const auto claims = DracoHead(bytes).read();
  if (!claims || !isPlausible(*claims, bytes.size(), context.memory->bound())) {
    draco.problem(claims ? "claims " + std::to_string(claims->faces) + " faces and " +
                               std::to_string(claims->points) + " points, too many for its " +
                               std::to_string(bytes.size()) + " bytes or for the memory"
                         : std::string("has data that are no mesh of Draco 2.2 without metadata"));
    return std::nullopt;
  }
  DracoMesh decoded(context, draco);
  ScratchArray<std::uint32_t> indices(context.memory);
  try {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char *>(bytes.data()), bytes.size());
    auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok()) {
      draco.problem(std::string("has broken data: ") + mesh.status().error_msg());
      return std::nullopt;
    }
    decoded.mesh_ = std::shared_ptr<const void>(std::shared_ptr<const draco::Mesh>(std::move(mesh).value()));
    context.scene.loaderPeakBytes += claims->faces * kBytesAFace;
    if (auto copied = copyIndices(meshOf(decoded.mesh_), indices); !copied) {
      context.problem.set(copied.error());
      return std::nullopt;
    }
  } catch (const std::exception &) {
    context.problem.set(Error::environment("out of memory for " + draco.name()));
    return std::nullopt;
  }
  const auto kept = std::make_shared<const ScratchArray<std::uint32_t>>(std::move(indices));
  context.scene.storage.push_back(kept);
  decoded.indices_ = {
      reinterpret_cast<const std::byte *>(kept->data()), kept->size(), 4, Type::Uint32, 1, false};
  return decoded;
}

AttributeView DracoMesh::attribute(const std::string &name) const {
  const auto id = draco_.object("attributes").count(name);
  if (!id)
    return {};
  const draco::Mesh &mesh = meshOf(mesh_);
  const draco::PointAttribute *found = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(*id));
  const auto type = found ? typeOf(found->data_type()) : std::nullopt;
  if (!type || found->num_components() < 1 || found->num_components() > 4) {
    draco_.problem("has no attribute " + std::to_string(*id) + ", which shall be " + name +
                   ", or one of a type that is not known");
    return {};
  }
  ScratchArray<std::byte> rows(context_->memory);
  if (auto copied = copyRows(*found, mesh.num_points(), rows); !copied) {
    if (copied.error().kind == ErrorKind::Input)
      draco_.problem(copied.error().message);
    else
      context_->problem.set(copied.error());
    return {};
  }
  const auto kept = std::make_shared<const ScratchArray<std::byte>>(std::move(rows));
  context_->scene.storage.push_back(kept);
  return {kept->data(),
          mesh.num_points(),
          static_cast<std::uint32_t>(found->byte_stride()),
          *type,
          static_cast<std::uint8_t>(found->num_components()),
          found->normalized()};
}

} // namespace voxc
