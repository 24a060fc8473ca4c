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
  # GCC forgets which of them are the system's, and warns of more of its bugs there, such as 105651.
  target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-stringop-overread)
  # It would clean up its memory several times a file; half a gigabyte holds any of them, and it takes a tenth of its time less.
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE --param=ggc-min-heapsize=524288)
  endif()
endfunction()

# Files with local names that others of their library have too, wherever they stand.
file(STRINGS "${CMAKE_CURRENT_LIST_DIR}/alone.txt" VOXC_ALONE REGEX "^[^#]")
list(TRANSFORM VOXC_ALONE PREPEND "${PROJECT_SOURCE_DIR}/")

# voxc_together(TARGET [FILE...]): the files of a library are compiled together, a dozen as one; but for these.
function(voxc_together target)
  if(VOXC_FIRST_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 12)
    set_source_files_properties(${VOXC_ALONE} ${ARGN} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    cmake_language(EVAL CODE "cmake_language(DEFER CALL voxc_deal ${target} ${ARGN})") # When all of its files are known.
  endif()
endfunction()

# voxc_deal(TARGET FILE...): files of one folder, whose local names are often the same, go to different dozens; but those that read LLVM's
# headers stay together.
function(voxc_deal target)
  get_target_property(sources ${target} SOURCES)
  set(others ${sources})
  list(FILTER others INCLUDE REGEX "/lib/Jit/")
  foreach(source IN LISTS VOXC_ALONE ARGN)
    if(source IN_LIST sources)
      list(APPEND others "${source}")
    endif()
  endforeach()
  list(REMOVE_ITEM sources ${others})
  list(LENGTH sources count)
  math(EXPR dozens "(${count} + 11) / 12")
  math(EXPR last "${count} - 1")
  set(dealt)
  foreach(first RANGE ${dozens})
    if(first LESS dozens)
      foreach(place RANGE ${first} ${last} ${dozens})
        list(GET sources ${place} source)
        list(APPEND dealt "${source}")
      endforeach()
    endif()
  endforeach()
  set_property(TARGET ${target} PROPERTY SOURCES ${dealt} ${others})
endfunction()
