# What voxc is built on; docs/dependencies.md says why each is here.
find_package(Vulkan 1.3 REQUIRED)
find_package(Threads REQUIRED)
find_path(VOXC_XXHASH_INCLUDE xxhash.h REQUIRED)
find_path(VOXC_ZSTD_INCLUDE zstd.h REQUIRED)
find_package(glm REQUIRED CONFIG)

# The compiler.
find_package(LLVM 19.1 REQUIRED CONFIG)
find_package(Clang REQUIRED CONFIG PATHS "${LLVM_LIBRARY_DIR}/cmake/clang" NO_DEFAULT_PATH)
find_package(SPIRV-Tools REQUIRED CONFIG)
find_package(SPIRV-Tools-opt REQUIRED CONFIG)
find_package(glslang 12 REQUIRED CONFIG)
find_package(Boost 1.74 REQUIRED)
find_package(nlohmann_json REQUIRED CONFIG)
find_package(ZLIB REQUIRED)
find_package(BZip2 REQUIRED)
find_package(EXPAT REQUIRED)
find_path(VOXC_PNG_INCLUDE png.h REQUIRED)
find_path(VOXC_TIFF_INCLUDE tiffio.h REQUIRED)
find_path(VOXC_BLOSC_INCLUDE blosc.h REQUIRED)
find_path(VOXC_TURBOJPEG_INCLUDE turbojpeg.h REQUIRED)
find_path(VOXC_DRACO_INCLUDE draco/compression/decode.h REQUIRED)
find_path(VOXC_MESHOPTIMIZER_INCLUDE meshoptimizer.h REQUIRED)
find_path(VOXC_WEBP_INCLUDE webp/decode.h REQUIRED)
find_path(VOXC_STB_INCLUDE stb_image.h PATH_SUFFIXES stb REQUIRED)

# The component that reads OpenVDB files. Not by default: its libraries would be loaded by every run of the driver.
option(VOXC_OPENVDB "Read OpenVDB files" OFF)
if(VOXC_OPENVDB)
  find_path(VOXC_OPENVDB_INCLUDE openvdb/openvdb.h REQUIRED)
  find_library(VOXC_OPENVDB_LIBRARY openvdb REQUIRED)
  find_library(VOXC_TBB_LIBRARY tbb REQUIRED)
  find_library(VOXC_IMATH_LIBRARY NAMES Imath-3_1 Imath REQUIRED)
endif()

# The component that reads meshes through assimp; not by default for the same reason.
option(VOXC_ASSIMP "Read .fbx, .dae, .3ds, .off, .x3d and other meshes through assimp" OFF)
if(VOXC_ASSIMP)
  find_path(VOXC_ASSIMP_INCLUDE assimp/scene.h REQUIRED)
  find_library(VOXC_ASSIMP_LIBRARY assimp REQUIRED)
endif()

# Kernels in HLSL and MSL, where there is what writes them.
find_package(spirv_cross_c_shared CONFIG QUIET)
option(VOXC_SPIRV_CROSS "Write kernels in HLSL and MSL, if SPIRV-Cross is found" ON)
if(VOXC_SPIRV_CROSS AND NOT TARGET spirv-cross-c-shared)
  message(STATUS "SPIRV-Cross is missing: voxc compile will not write HLSL and MSL")
  set(VOXC_SPIRV_CROSS OFF)
endif()

# The tools.
find_package(CLI11 REQUIRED CONFIG)

# The window of `voxc view`, where there is all that it needs: GLFW, Dear ImGui (which needs stb's library) and a Vulkan loader.
option(VOXC_VIEW "Build the window of voxc view, if GLFW and Dear ImGui are found" ON)
if(NOT VOXC_APPS)
  set(VOXC_VIEW OFF)
endif()
if(VOXC_VIEW)
  find_package(glfw3 3.3 CONFIG QUIET)
  find_path(VOXC_IMGUI_INCLUDE imgui.h PATH_SUFFIXES imgui)
  find_library(VOXC_IMGUI_LIBRARY imgui)
  find_library(VOXC_STB_LIBRARY stb)
  if(NOT (TARGET glfw AND TARGET Vulkan::Vulkan AND VOXC_IMGUI_INCLUDE AND VOXC_IMGUI_LIBRARY AND VOXC_STB_LIBRARY))
    message(STATUS "GLFW or Dear ImGui is missing: voxc view will have no window")
    set(VOXC_VIEW OFF)
  endif()
endif()
