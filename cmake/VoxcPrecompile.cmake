# Reading the standard library's headers takes a third of the time of a first build. Where nothing keeps compiled
# files from build to build, each large library reads the most used ones once. (ccache keeps none that were compiled so.)
if(VOXC_CCACHE)
  set(usual OFF)
else()
  set(usual ON)
endif()
option(VOXC_PRECOMPILE "Read the most used headers once for each library" ${usual})

set(VOXC_STANDARD_HEADERS
    <algorithm> <array> <bit> <charconv> <cmath> <cstdint> <cstring> <filesystem> <functional> <map> <memory> <optional>
    <span> <string> <string_view> <utility> <vector>)

# voxc_precompile(TARGET [HEADER...]): the standard headers, and these; or, as REUSE_FROM OTHER, what another target has.
function(voxc_precompile target)
  if(VOXC_PRECOMPILE)
    if("${ARGV1}" STREQUAL "REUSE_FROM")
      target_precompile_headers(${target} ${ARGN})
    else()
      target_precompile_headers(${target} PRIVATE ${VOXC_STANDARD_HEADERS} ${ARGN})
    endif()
    # GCC forgets which of them are the system's, and warns of more of its bug 105651 there.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
    # It would clean up its memory several times a file; half a gigabyte holds any of them, and it takes a tenth of its time less.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=524288)
    endif()
  endif()
endfunction()
