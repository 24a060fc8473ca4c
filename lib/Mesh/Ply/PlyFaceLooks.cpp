// The names that programs give to what faces say, and what becomes of it.
#include "Mesh/Ply/PlyFaceLooks.h"

namespace voxc {

namespace {

constexpr std::array<std::string_view, 5> kUvLists{"texcoord", "texcoords", "texture_coordinates", "uv",
                                                   "uvs"};
constexpr std::array<std::string_view, 5> kNumbers{"texnumber", "tex_number", "texture_number",
                                                   "texture_index", "texindex"};

constexpr std::uint32_t kOpaque = 0xff000000;

} // namespace

PlyFaceLooks::PlyFaceLooks(const PlyHeader &header, const PlyElement &faces, bool hasVertexUvs,
                           const std::shared_ptr<WorkingMemory> &memory, Problem &problem)
    : faces_(faces), problem_(problem), textures_(header.textures.size()), colour_(faces),
      triangles_(memory) {
  if (textures_ == 0)
    return;
  uvs_ = findList(faces, kUvLists);
  if (uvs_ || hasVertexUvs)
    for (const std::string_view name : kNumbers)
      number_ = number_ ? number_ : findNumber(faces, name);
}

void PlyFaceLooks::read(const PlyRow &row, std::size_t corners) {
  face_ = {};
  if (colour_)
    face_.colour = colour_(row);
  alphas_ |= face_.colour & kOpaque;
  if (!uvs_ && !number_)
    return;
  const double number = number_ ? row.values[*number_] : 0;
  const bool isThere = number >= 0 && number < static_cast<double>(textures_);
  const std::vector<double> *const list = uvs_ ? &row.lists[*uvs_] : nullptr;
  // A face with the number -1 or without coordinates has no texture; all else is a mistake.
  const bool isPlain = number == -1 || (list && list->empty());
  const bool isUsable = isThere && !isPlain && (!list || list->size() == 2 * corners);
  badFaces_ += !isPlain && !isUsable;
  if (!isUsable)
    return;
  face_.texture = static_cast<std::int32_t>(number);
  faceUvs_.clear();
  for (std::size_t i = 0; list && i < corners; ++i)
    faceUvs_.push_back({static_cast<float>((*list)[2 * i]), static_cast<float>(1 - (*list)[2 * i + 1])});
}

void PlyFaceLooks::add(const std::array<std::uint32_t, 3> &places) {
  if (face_.texture >= 0 && uvs_)
    for (std::size_t i = 0; i < places.size(); ++i)
      face_.uvs[i] = faceUvs_[places[i]];
  problem_.check(triangles_.push(face_));
}

void PlyFaceLooks::addPlain() { problem_.check(triangles_.push({})); }

void PlyFaceLooks::showInvisible() {
  if (areInvisible())
    for (Look &look : triangles_.span())
      look.colour |= kOpaque;
}

void PlyFaceLooks::take(PlyUse &use) const {
  colour_.take(use);
  use.take(faces_, uvs_);
  use.take(faces_, number_);
}

} // namespace voxc
