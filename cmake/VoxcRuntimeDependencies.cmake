# What the runtime is built on, and what converts and verifies without a compiler. Of libraries that are headers alone no more is asked
# than to be found: another system's are those of this machine (scripts/windows.sh).
find_package(ZLIB REQUIRED)
find_path(VOXC_PNG_INCLUDE png.h REQUIRED)

# voxc_headers(TARGET HEADER): a library that is headers alone.
function(voxc_headers target header)
  string(MAKE_C_IDENTIFIER "VOXC_${target}_INCLUDE" folder)
  find_path(${folder} ${header} REQUIRED)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} INTERFACE "${${folder}}")
endfunction()

voxc_headers(glm::glm glm/glm.hpp)
voxc_headers(Vulkan::Headers vulkan/vulkan_core.h)
voxc_headers(Boost::headers boost/multiprecision/cpp_int.hpp)
