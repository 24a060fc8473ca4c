# How everything is compiled and linked.
option(VOXC_BUILD_TESTS "Build the unit tests and configure the lit tests" ON)
option(VOXC_APPS "Build the viewer, pages, measurements and building on many machines, the tests, and the programs of developers" ON)
option(VOXC_RUNTIME_ONLY "Build the runtime, what converts and verifies without a compiler, and their tests; LLVM is not looked for" OFF)
option(VOXC_FUZZ "Build the fuzzers and nothing else; needs Clang" OFF)
# What stands on the runtime: the compiler, or what of it needs no LLVM.
set(VOXC_COMPILER voxc-compiler)
if(VOXC_RUNTIME_ONLY)
  set(VOXC_COMPILER voxc-voxels)
endif()
option(VOXC_WERROR "Treat warnings as errors" OFF)
set(VOXC_SANITIZE "" CACHE STRING "Sanitizers, such as address,undefined")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/lib")

find_program(VOXC_CCACHE ccache)
if(VOXC_CCACHE AND NOT VOXC_FIRST_BUILD)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${VOXC_CCACHE}")
endif()

# Debian's lld 19 installs no plain ld.lld; GCC finds the linker by this directory.
find_program(VOXC_LLD NAMES ld.lld PATHS /usr/lib/llvm-19/bin NO_DEFAULT_PATH)
if(VOXC_LLD AND NOT WIN32)
  get_filename_component(lldDirectory "${VOXC_LLD}" DIRECTORY)
  add_link_options(-fuse-ld=lld "-B${lldDirectory}")
endif()

# The flags of voxc's own targets; not of those who link to it.
add_library(voxc-flags INTERFACE)
# GCC 12 warns of overlap in "literal" + std::string where there is none (its bug 105651).
target_compile_options(voxc-flags INTERFACE -Wall -Wextra -Wpedantic -Wno-missing-field-initializers -Wno-restrict
                                            -ffp-contract=off)
include(VoxcRounding)
if(VOXC_WERROR)
  target_compile_options(voxc-flags INTERFACE -Werror)
endif()
if(VOXC_SANITIZE)
  # glslang is built without RTTI, which the vptr check would need.
  target_compile_options(voxc-flags INTERFACE -fsanitize=${VOXC_SANITIZE} -fno-sanitize=vptr -fno-omit-frame-pointer)
  target_link_options(voxc-flags INTERFACE -fsanitize=${VOXC_SANITIZE})
endif()
