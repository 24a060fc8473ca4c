// Code and its folders by Windows.
#include "Code.h"

#include "File.h"
#include "WindowsApi.h"
#include "WindowsError.h"
#include "WindowsText.h"

#include <array>
#include <cerrno>

namespace voxc::platform {

std::string identityOfCode(const void *function) {
  HMODULE module = nullptr;
  constexpr DWORD kByAddress =
      GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
  std::array<wchar_t, 32768> path{};
  WIN32_FILE_ATTRIBUTE_DATA facts{};
  if (!::GetModuleHandleExW(kByAddress, static_cast<const wchar_t *>(function), &module) ||
      ::GetModuleFileNameW(module, path.data(), static_cast<DWORD>(path.size())) == 0 ||
      !::GetFileAttributesExW(path.data(), GetFileExInfoStandard, &facts))
    return "";
  const auto text = [](DWORD high, DWORD low) { return std::to_string(std::uint64_t{high} << 32 | low); };
  return text(facts.nFileSizeHigh, facts.nFileSizeLow) + " " +
         text(facts.ftLastWriteTime.dwHighDateTime, facts.ftLastWriteTime.dwLowDateTime);
}

bool makeOwnFolder(const std::string &path) {
  return succeeded(::CreateDirectoryW(wide(path).c_str(), nullptr)) || errno == EEXIST;
}

/// A folder is as private as the one that it is in, such as a user's own.
Folder ownershipOf(const std::string &path) {
  return kindOf(path) == PathKind::Folder ? Folder::Own : Folder::None;
}

} // namespace voxc::platform
