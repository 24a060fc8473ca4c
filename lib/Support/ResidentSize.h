// How much of this process is in memory.
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace voxc {

/// Bytes of this process that are in memory now; 0 where the system does not tell.
class ResidentSize {
public:
  ResidentSize() : file_(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC)) {}
  ~ResidentSize() {
    if (file_ >= 0)
      ::close(file_);
  }
  ResidentSize(const ResidentSize &) = delete;
  ResidentSize &operator=(const ResidentSize &) = delete;

  std::uint64_t now() const {
    std::array<char, 128> text{};
    if (file_ < 0 || ::pread(file_, text.data(), text.size() - 1, 0) <= 0)
      return 0;
    const std::string_view numbers(text.data());
    const std::size_t blank = std::min(numbers.find(' '), numbers.size() - 1);
    std::uint64_t pages = 0;
    std::from_chars(numbers.data() + blank + 1, numbers.data() + numbers.size(), pages);
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  }

private:
  int file_;
};

} // namespace voxc
