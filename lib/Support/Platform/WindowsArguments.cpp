// What `main` is given has lost the letters that the system's old encoding lacks: Windows is asked again.
#include "Arguments.h"

#include "WindowsApi.h"
#include "WindowsText.h"

#include <shellapi.h>

namespace voxc::platform {

std::vector<std::string> argumentsOf(int /*count*/, char ** /*values*/) {
  int count = 0;
  wchar_t **const values = ::CommandLineToArgvW(::GetCommandLineW(), &count);
  std::vector<std::string> arguments;
  for (int i = 1; values && i < count; ++i)
    arguments.push_back(narrow(values[i]));
  ::LocalFree(values);
  return arguments;
}

} // namespace voxc::platform
