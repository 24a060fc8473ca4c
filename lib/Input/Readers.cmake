# What reads voxel inputs and needs no voxelizer; fuzzers build it apart from all else.
set(VOXC_INPUT_READERS
  Dense/ColourMap.cpp
  Dense/DenseFacts.cpp
  Dense/DenseVolume.cpp
  Dense/GzipReader.cpp
  Dense/Histogram.cpp
  Dense/NiftiHeader.cpp
  Dense/NrrdHeader.cpp
  Dense/PngSlice.cpp
  Dense/SampleChecks.cpp
  Dense/Samples.cpp
  MagicaVoxel/Placement.cpp
  MagicaVoxel/VoxFile.cpp
  MagicaVoxel/VoxScene.cpp
  NanoVdb/NanoVdbFile.cpp
  NanoVdb/NanoVdbGrid.cpp
  NanoVdb/ValueKind.cpp
  Openers/InputText.cpp
  Openers/OpenBinvox.cpp
  Openers/OpenMagicaVoxel.cpp
  Openers/OpenNanoVdb.cpp
  Openers/OpenNifti.cpp
  Openers/OpenNrrd.cpp
  Openers/OpenSlices.cpp
  Points/PointList.cpp
  Points/PointSource.cpp)
set(VOXC_INPUT_READER_LIBRARIES ZLIB::ZLIB png)
