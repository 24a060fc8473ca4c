# The readers, which the fuzzers build apart from all else: all of lib/Mesh but what makes voxels.
file(GLOB_RECURSE VOXC_MESH_READERS CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/*.cpp")
list(FILTER VOXC_MESH_READERS EXCLUDE REGEX "/Mesh/(Solid|Voxelize)/|/ModelFrame.cpp$")
# What they are built on, beside lib/Image.
set(VOXC_MESH_READER_LIBRARIES $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> draco meshoptimizer)
