# The programs have LLVM and Clang within, where the archives of both are there. As shared libraries they have 576,000 relocations,
# which every start pays, be it for `voxc --version`: 3,500 pages that are written anew. As archives, only what is used is taken.
set(archiveDefault ON)
if(VOXC_SANITIZE)
  set(archiveDefault OFF) # Nothing of LLVM is sanitized, and containers that cross over would seem broken.
endif()
option(VOXC_STATIC_LLVM "Link LLVM and Clang into the programs, if their archives are found" ${archiveDefault})
option(VOXC_PIE "Place the programs anywhere in memory, which attackers cannot predict; without, they start in a quarter less time" ON)

if(VOXC_STATIC_LLVM)
  file(GLOB VOXC_LLVM_ARCHIVES "${LLVM_LIBRARY_DIR}/libLLVM*.a" "${LLVM_LIBRARY_DIR}/libclang?*.a")
  if(NOT EXISTS "${LLVM_LIBRARY_DIR}/libLLVMOrcJIT.a" OR NOT EXISTS "${LLVM_LIBRARY_DIR}/libclangCodeGen.a")
    message(STATUS "The archives of LLVM or Clang are missing: the programs will load their shared libraries, and start slower")
    set(VOXC_STATIC_LLVM OFF)
  endif()
endif()

set(VOXC_LLVM_WITHIN "${VOXC_STATIC_LLVM}" CACHE INTERNAL "Whether LLVM is within the programs")

# voxc_program(TARGET): how a program is linked that is installed.
function(voxc_program target)
  set_target_properties(${target} PROPERTIES VOXC_HAS_LLVM_WITHIN ${VOXC_LLVM_WITHIN})
  if(VOXC_STATIC_LLVM)
    target_link_options(${target} PRIVATE -Wl,--gc-sections)
  endif()
  if(NOT VOXC_PIE)
    target_link_options(${target} PRIVATE -no-pie)
  elseif(VOXC_PACKS_RELOCATIONS)
    target_link_options(${target} PRIVATE -Wl,-z,pack-relative-relocs)
  endif()
endfunction()

# Relocations that only add where the program lies take two bits in place of 24 bytes; glibc knows them from 2.36 on.
if(VOXC_PIE AND NOT CMAKE_CROSSCOMPILING)
  include(CheckCXXSourceRuns)
  set(CMAKE_REQUIRED_LINK_OPTIONS -Wl,-z,pack-relative-relocs)
  check_cxx_source_runs("int value; int *place = &value; int main() { return *place; }" VOXC_PACKS_RELOCATIONS)
  unset(CMAKE_REQUIRED_LINK_OPTIONS)
endif()
