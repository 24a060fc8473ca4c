// Writing screenshots.
#include "view/Screenshots.h"

#include "view/NumberedFile.h"

#include "common/Png.h"

namespace voxc::view {

std::optional<Expected<std::string>> Screenshots::write(Picture picture) {
  if (writer_.joinable())
    writer_.join();
  auto before = take();
  writer_ =
      std::jthread([this, path = nextNumberedPath(folder_, ".png", number_), picture = std::move(picture)] {
        const Expected<void> written = tool::writePng(path, picture);
        written_.put(written ? Expected<std::string>(path) : written.error());
        wake_();
      });
  return before;
}

} // namespace voxc::view
