// Memory as Linux tells of it.
#include "Memory.h"

#include "Pages.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace voxc::platform {

std::uint64_t physicalMemory() { return static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * pageBytes(); }

ResidentSize::ResidentSize() : file_(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC)) {}

ResidentSize::~ResidentSize() {
  if (file_ >= 0)
    ::close(file_);
}

std::uint64_t ResidentSize::now() const {
  std::array<char, 128> text{};
  if (file_ < 0 || ::pread(file_, text.data(), text.size() - 1, 0) <= 0)
    return 0;
  const std::string_view numbers(text.data());
  const std::size_t blank = std::min(numbers.find(' '), numbers.size() - 1);
  std::uint64_t pages = 0;
  std::from_chars(numbers.data() + blank + 1, numbers.data() + numbers.size(), pages);
  return pages * pageBytes();
}

} // namespace voxc::platform
