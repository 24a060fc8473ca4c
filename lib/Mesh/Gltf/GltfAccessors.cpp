// Checking that accessors lie in their buffers; writing out the sparse ones.
#include "Mesh/Gltf/GltfAccessors.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace voxc {

namespace {

using Type = AttributeView::Type;

struct ComponentRow {
  std::uint64_t code;
  Type type;
  std::uint32_t bytes;
};

/// The last two are no component types of the specification, but clear in what they mean.
constexpr std::array<ComponentRow, 8> kComponents{{{5120, Type::Int8, 1},
                                                   {5121, Type::Uint8, 1},
                                                   {5122, Type::Int16, 2},
                                                   {5123, Type::Uint16, 2},
                                                   {5125, Type::Uint32, 4},
                                                   {5126, Type::Float32, 4},
                                                   {5124, Type::Int32, 4},
                                                   {5130, Type::Float64, 8}}};

struct ShapeRow {
  std::string_view name;
  std::uint8_t components;
};

constexpr std::array<ShapeRow, 5> kShapes{
    {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}}};

/// What an accessor without data shows again and again.
constexpr std::array<std::byte, 128> kZeros{};

/// How often accessors may show the same bytes. Files in which they show them ten times are odd, and those
/// that say so thousands of times in a few kilobytes would cost time without end.
constexpr std::uint64_t kMostShown = 64;

const ComponentRow *findComponent(const GltfObject &json) {
  const auto code = json.count("componentType");
  const auto *row = std::find_if(kComponents.begin(), kComponents.end(),
                                 [&](const ComponentRow &r) { return r.code == code; });
  return row == kComponents.end() ? nullptr : row;
}

std::uint32_t rowBytes(const AttributeView &view) {
  const auto *row = std::find_if(kComponents.begin(), kComponents.end(),
                                 [&](const ComponentRow &r) { return r.type == view.type; });
  return row->bytes * view.components;
}

/// Type and count of the rows. Nothing, with a problem, if they make no sense.
std::optional<AttributeView> readShape(const GltfObject &json) {
  const ComponentRow *component = findComponent(json);
  const std::string_view name = json.text("type");
  const auto *shape =
      std::find_if(kShapes.begin(), kShapes.end(), [&](const ShapeRow &r) { return r.name == name; });
  const std::uint64_t count = json.count("count").value_or(0);
  if (!component)
    json.problem("has no componentType that is known");
  else if (shape == kShapes.end())
    json.problem("is not of the type SCALAR, VEC2, VEC3, VEC4 or MAT4");
  else if (count > std::numeric_limits<std::uint32_t>::max())
    json.problem("has a count of " + std::to_string(count) + ", more than 2^32");
  else
    return AttributeView{nullptr, count, 0, component->type, shape->components, json.flag("normalized")};
  return std::nullopt;
}

} // namespace

GltfAccessors::GltfAccessors(GltfContext &context, GltfBuffers &buffers)
    : context_(context), buffers_(buffers), list_(context.root.list("accessors")), known_(list_.size()) {}

AttributeView GltfAccessors::view(std::size_t index) {
  Known &known = known_[index];
  if (!known.isRead) {
    known.view = read(list_[index]);
    known.isRead = true;
  }
  return known.view;
}

AttributeView GltfAccessors::read(const GltfObject &json) {
  auto view = readShape(json);
  if (!view)
    return {};
  view->data = kZeros.data();
  if (json.has("bufferView")) {
    if (!place(*view, json))
      return {};
  } else if (view->count > buffers_.bytesOfFiles()) {
    json.problem("has a count of " + std::to_string(view->count) + " and no data");
    return {};
  }
  if (!spend(*view, json))
    return {};
  return json.has("sparse") && view->count != 0 ? withSparse(*view, json) : *view;
}

bool GltfAccessors::place(AttributeView &view, const GltfObject &json) {
  const auto index = json.index("bufferView", buffers_.views());
  if (!index) {
    json.problem("has no buffer view");
    return false;
  }
  const GltfBuffers::View rows = buffers_.view(*index);
  const std::uint64_t offset = json.count("byteOffset").value_or(0);
  const std::uint64_t bytes = rowBytes(view);
  view.stride = rows.stride == 0 ? static_cast<std::uint32_t>(bytes) : rows.stride;
  const std::uint64_t needed = view.count == 0 ? 0 : (view.count - 1) * view.stride + bytes;
  if (offset > rows.bytes.size() || needed > rows.bytes.size() - offset) {
    json.problem("reaches over the end of its buffer view, which has " + std::to_string(rows.bytes.size()) +
                 " bytes");
    return false;
  }
  if (needed != 0)
    view.data = rows.bytes.data() + offset;
  return true;
}

bool GltfAccessors::spend(const AttributeView &view, const GltfObject &json) {
  bytesSpent_ += view.count * rowBytes(view);
  if (bytesSpent_ / kMostShown <= buffers_.bytesOfFiles())
    return true;
  json.problem("and those before it show " + std::to_string(bytesSpent_) +
               " bytes, but the files have only " + std::to_string(buffers_.bytesOfFiles()));
  return false;
}

AttributeView GltfAccessors::withSparse(const AttributeView &base, const GltfObject &json) {
  const std::uint64_t bytes = rowBytes(base);
  ScratchArray<std::byte> rows(context_.memory);
  if (auto resized = rows.resize(base.count * bytes); !resized) {
    context_.problem.set(resized.error());
    return {};
  }
  for (std::uint64_t i = 0; i < base.count; ++i)
    std::memcpy(rows.data() + i * bytes, base.data + i * base.stride, bytes);
  if (!overwrite(rows.data(), base, json.object("sparse")))
    return {};
  const auto kept = std::make_shared<const ScratchArray<std::byte>>(std::move(rows));
  context_.scene.storage.push_back(kept);
  AttributeView view = base;
  view.data = kept->data();
  view.stride = static_cast<std::uint32_t>(bytes);
  return view;
}

bool GltfAccessors::overwrite(std::byte *rows, const AttributeView &base, const GltfObject &sparse) {
  const std::uint64_t count = sparse.count("count").value_or(0);
  const GltfObject where = sparse.object("indices");
  const ComponentRow *component = findComponent(where);
  if (!component || (component->type != Type::Uint8 && component->type != Type::Uint16 &&
                     component->type != Type::Uint32)) {
    where.problem("has no componentType that indices may have");
    return false;
  }
  if (count > base.count) {
    sparse.problem("has a count of " + std::to_string(count) + ", more than its accessor");
    return false;
  }
  AttributeView indices{nullptr, count, 0, component->type, 1, false};
  AttributeView values = base;
  values.count = count;
  if (!place(indices, where) || !place(values, sparse.object("values")))
    return false;
  const std::uint64_t bytes = rowBytes(base);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint32_t row = readIndex(indices, i);
    if (row >= base.count) {
      where.problem("name row " + std::to_string(row) + " of " + std::to_string(base.count));
      return false;
    }
    std::memcpy(rows + row * bytes, values.data + i * values.stride, bytes);
  }
  return true;
}

} // namespace voxc
