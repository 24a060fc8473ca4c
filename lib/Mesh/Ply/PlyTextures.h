// Textures of PLY files, and the parts that faces with looks of their own become.
#pragma once

#include "Mesh/MeshInput.h"
#include "Mesh/Ply/PlyFaceLooks.h"
#include "Support/Problem.h"
#include "Support/Warnings.h"
#include "voxc/Mesh/TriangleScene.h"

namespace voxc {

/// Adds to a scene without materials a plain one, and behind it one for each texture that the header names. A
/// texture that cannot be read is a warning, and plain.
void addTextures(const PlyHeader &header, const MeshInput &input, TriangleScene &scene, Warnings &warnings,
                 Problem &problem);

/// Adds the triangles of `part` to the scene, where they are: with the first texture if there is one and
/// vertices have coordinates for it. A texture stands in place of colours.
void addPart(MeshPart part, TriangleScene &scene, Warnings &warnings);

/// The same where each triangle has a look: triangles of one texture become a part, whose corners have all
/// their attributes to themselves.
void addPartsByLook(const MeshPart &part, const PlyFaceLooks &looks,
                    const std::shared_ptr<WorkingMemory> &memory, TriangleScene &scene, Warnings &warnings,
                    Problem &problem);

} // namespace voxc
