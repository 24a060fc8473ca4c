# The readers, which the fuzzers build apart from all else.
set(VOXC_MESH_READERS
  Gltf/DataUri.cpp
  Gltf/GltfAccessors.cpp
  Gltf/GltfBuffers.cpp
  Gltf/GltfExtensions.cpp
  Gltf/GltfFile.cpp
  Gltf/GltfMaterials.cpp
  Gltf/GltfMeshes.cpp
  Gltf/GltfNodes.cpp
  Gltf/GltfObject.cpp
  Gltf/GltfReader.cpp
  Gltf/GltfTransforms.cpp
  Gltf/Json.cpp
  Image/ImageDecoder.cpp
  Image/Jpeg.cpp
  Image/OtherImage.cpp
  Image/Png.cpp
  Image/TextureSet.cpp
  Obj/MaterialLibrary.cpp
  Obj/ObjGeometry.cpp
  Obj/ObjMaterials.cpp
  Obj/ObjReader.cpp
  Ply/PlyColour.cpp
  Ply/PlyHeader.cpp
  Ply/PlyReader.cpp
  Ply/PlyScene.cpp
  Polygon.cpp
  NumberCheck.cpp
  SceneLoader.cpp
  Stl/StlReader.cpp
  Stl/StlText.cpp
  TriangleScene.cpp)
# What they are built on, beside stb_image, a header.
set(VOXC_MESH_READER_LIBRARIES $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> png turbojpeg)
