# What reads voxel inputs and needs no other part of the compiler; fuzzers build it apart from all else.
set(VOXC_SOURCE_READERS
  BinnedVoxels.cpp
  ChunkBricks.cpp
  ChunkedSource.cpp
  Dense/ColourMap.cpp
  Dense/DenseVolume.cpp
  Dense/GzipReader.cpp
  Dense/NiftiHeader.cpp
  Dense/NrrdHeader.cpp
  Dense/Samples.cpp
  DenseSource.cpp
  MagicaVoxel/Placement.cpp
  MagicaVoxel/VoxFile.cpp
  MagicaVoxel/VoxScene.cpp
  OccupancyPyramid.cpp
  Openers/InputText.cpp
  Openers/OpenBinvox.cpp
  Openers/OpenMagicaVoxel.cpp
  Openers/OpenNifti.cpp
  Openers/OpenNrrd.cpp
  PointList.cpp
  PointSource.cpp)
set(VOXC_SOURCE_READER_LIBRARIES ZLIB::ZLIB)
