# Whether the compiler keeps the rounding of doubles to float32, and what makes it do so. g++ 12 drops it at -O2 and -O3 where it
# takes two components of a vector at once, which its later versions do not: no number of voxc may depend on that.

# voxc_keeps_rounding(RESULT FLAGS...): whether the optimiser does with these flags. Where programs cannot be run, only Clang,
# which has never dropped it, is taken at its word.
function(voxc_keeps_rounding result)
  if(DEFINED ${result})
    return()
  endif()
  if(CMAKE_CROSSCOMPILING AND NOT CMAKE_CROSSCOMPILING_EMULATOR)
    string(FIND "${ARGN} ${CMAKE_CXX_COMPILER_ID}" "no-tree-slp-vectorize" option)
    set(kept FALSE)
    if(CMAKE_CXX_COMPILER_ID MATCHES "Clang" OR NOT option EQUAL -1)
      set(kept TRUE)
    endif()
  else()
    try_run(status isCompiled "${CMAKE_BINARY_DIR}" "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/Rounding.cpp"
            COMPILE_DEFINITIONS -O3 ${ARGN} CXX_STANDARD 20)
    unset(kept)
    if(isCompiled AND status EQUAL 0)
      set(kept TRUE)
    else()
      set(kept FALSE)
    endif()
    unset(status CACHE)
    unset(isCompiled CACHE)
  endif()
  set(${result} ${kept} CACHE INTERNAL "Whether '${ARGN}' keeps the rounding of doubles to float32")
endfunction()

voxc_keeps_rounding(VOXC_KEEPS_ROUNDING)
if(NOT VOXC_KEEPS_ROUNDING)
  voxc_keeps_rounding(VOXC_KEEPS_ROUNDING_WITHOUT_SLP -fno-tree-slp-vectorize)
  if(NOT VOXC_KEEPS_ROUNDING_WITHOUT_SLP)
    message(FATAL_ERROR "${CMAKE_CXX_COMPILER} drops the rounding of doubles to float32 (cmake/Rounding.cpp); use another compiler, "
                        "or leave out flags such as -ffast-math")
  endif()
  message(STATUS "The compiler drops roundings to float32 where it joins components of vectors: -fno-tree-slp-vectorize")
  target_compile_options(voxc-flags INTERFACE -fno-tree-slp-vectorize)
endif()
