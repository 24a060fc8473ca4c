// Decoding images when they are first asked for.
#include "Mesh/TextureSet.h"

#include "Support/WatchedFile.h"

namespace voxc {

Expected<Texture> TextureSet::decode(std::span<const std::byte> bytes) {
  auto image = VOXC_TRY(decoder_.decode(bytes));
  return Texture{image.width, image.height,
                 std::make_shared<const ScratchArray<std::uint32_t>>(std::move(image.texels))};
}

Expected<int> TextureSet::readFile(const std::string &path) {
  return read(path, path, [&](const Decode &decode) -> Expected<Texture> {
    auto file = WatchedFile::open(path, memory_);
    if (!file)
      return Error::input(file.error().message); // Whatever the reason, a model can do without.
    scene_.files.push_back(path);
    return decode((*file)->bytes());
  });
}

Expected<int> TextureSet::read(const std::string &key, const std::string &name, const Use &use) {
  const auto [entry, isNew] = indices_.try_emplace(key, -1);
  if (!isNew)
    return entry->second;
  auto texture = use([&](std::span<const std::byte> bytes) { return decode(bytes); });
  if (texture) {
    scene_.textures.push_back(std::move(*texture));
    entry->second = static_cast<int>(scene_.textures.size()) - 1;
  } else if (texture.error().kind == ErrorKind::Input) {
    warnings_.add("the texture '" + name + "' is left out: " + texture.error().message);
  } else {
    return texture.error();
  }
  return entry->second;
}

} // namespace voxc
