// Pictures of models in the report.
#include "report/Thumbnail.h"

#include "Mesh/Image/ImageDecoder.h"
#include "common/SmallPicture.h"
#include "voxc/Support/File.h"

namespace voxc::report {
namespace {

Expected<Picture> readPicture(const std::string &path) {
  auto file = MappedFile::open(path);
  if (!file)
    return file.error();
  auto texture = ImageDecoder(WorkingMemory::createDefault()).decode(file->bytes());
  if (!texture)
    return Error::input("the picture '" + path + "' cannot be read: " + texture.error().message);
  const auto texels = texture->texels->span();
  return Picture{texture->width, texture->height, {texels.begin(), texels.end()}};
}

} // namespace

Expected<std::string> thumbnail(const std::string &path, std::size_t mostBytes) {
  const Expected<Picture> picture = readPicture(path);
  if (!picture)
    return picture.error();
  std::string address = tool::pictureAddress(*picture, mostBytes);
  return address.empty()
             ? Error::input("the picture '" + path + "' cannot be made as small as the report wants it")
             : Expected<std::string>(std::move(address));
}

} // namespace voxc::report
