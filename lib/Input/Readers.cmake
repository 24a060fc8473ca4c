# What reads voxel inputs and needs no voxelizer; fuzzers build it apart from all else.
file(GLOB_RECURSE VOXC_INPUT_READERS CONFIGURE_DEPENDS "${CMAKE_CURRENT_LIST_DIR}/*/*.cpp")
list(FILTER VOXC_INPUT_READERS EXCLUDE REGEX "/Openers/Mesh|/Open(Builtin|Grid|Mesh|Ply|Raw|Volume).cpp$|/ScenePoints.cpp$")
set(VOXC_INPUT_READER_LIBRARIES z bz2 expat tiff blosc)
