# Most of the time of a first build goes to reading the same headers for each file. Two ways around that, neither of which
# helps who changes a file, builds again and has ccache: headers that a library reads once, and files compiled together.
option(VOXC_FIRST_BUILD "Build from nothing in the least time: files are compiled together, and ccache is not asked" OFF)
if(VOXC_FIRST_BUILD OR NOT VOXC_CCACHE)
  set(VOXC_PRECOMPILE ON)
else()
  set(VOXC_PRECOMPILE OFF)
endif()

set(VOXC_STANDARD_HEADERS
    <algorithm> <array> <bit> <charconv> <cmath> <cstdint> <cstring> <filesystem> <functional> <map> <memory> <numeric>
    <optional> <span> <string> <string_view> <utility> <vector>)

# voxc_precompile(TARGET [HEADER...]): the standard headers, and these; or, as REUSE_FROM OTHER, what another target has.
function(voxc_precompile target)
  if(NOT VOXC_PRECOMPILE)
    return()
  endif()
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
endfunction()

# Files with local names that others of their library have too.
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/alone.txt" VOXC_ALONE REGEX "^[^#]")

# voxc_together(TARGET): the files of a library are compiled together, a dozen as one.
function(voxc_together target)
  if(NOT VOXC_FIRST_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
  list(TRANSFORM VOXC_ALONE PREPEND "${PROJECT_SOURCE_DIR}/" OUTPUT_VARIABLE alone)
  set_source_files_properties(${alone} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
