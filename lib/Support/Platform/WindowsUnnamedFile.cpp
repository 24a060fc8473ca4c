// Windows has no files without a name that could be given one: new files have another name until then.
#include "UnnamedFile.h"

#include "WindowsHandle.h"

#include <cerrno>
#include <random>

namespace voxc::platform {
namespace {

constexpr int kAttempts = 100;

std::string sixLetters() {
  std::random_device random;
  std::uniform_int_distribution<int> letter('a', 'z');
  std::string letters(6, 0);
  for (char &one : letters)
    one = static_cast<char>(letter(random));
  return letters;
}

} // namespace

int openUnnamed(const std::string & /*path*/, Access /*access*/) {
  errno = ENOTSUP;
  return -1;
}

bool hasNoUnnamed(int error) { return error == ENOTSUP; }

bool canBeNamed(int /*file*/) { return false; }

bool giveName(int /*file*/, const std::string & /*path*/) {
  errno = ENOTSUP;
  return false;
}

/// Who may open a file is a matter of its folder.
int openNew(std::string &path, Access /*access*/) {
  for (int attempt = 0;; ++attempt) {
    std::string name = path + "." + sixLetters();
    const int file = openFile(name, GENERIC_READ | GENERIC_WRITE | DELETE, CREATE_NEW);
    if (file < 0 && errno == EEXIST && attempt < kAttempts)
      continue;
    path = std::move(name);
    return file;
  }
}

} // namespace voxc::platform
