#version 460
// ${prefix-}.rint: where rays meet volumes of the format ${FORMAT}, for boxes in acceleration structures. It needs
// ${prefix-}.h beside it, and ${prefix-}.rchit, or another closest-hit shader with this attribute, in its hit group.
#extension GL_EXT_ray_tracing : require
#extension GL_EXT_buffer_reference : require
#extension GL_GOOGLE_include_directive : require

// The address of a volume's words stands in the record of the hit group, behind its handle.
layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer Words { uint words[]; };
layout(shaderRecordEXT, std430) buffer Record { Words volume; };

#define VOXC_VOLUME Words
#define VOXC_LOAD(volume, index) volume.words[index]
#include "${prefix-}.h"

hitAttributeEXT ${prefix}Hit reached;

// Objects are in voxels: a box from 0 to ${prefix}VOLUME_SIZE holds the volume, and an instance's transform leads from there to
// the world. A hit's kind is its face: twice its axis, and 1 more for the high one; 6 where the ray begins in the voxel. An any-hit
// shader that ignores a voxel lets the ray go on to the next.
void main() {
  ${prefix}Hit hit;
  bool found = ${prefix}closest(volume, gl_ObjectRayOriginEXT, gl_ObjectRayDirectionEXT, gl_RayTminEXT, gl_RayTmaxEXT, hit);
  bool accepted = false;
  while (found && !accepted) {
    reached = hit;
    accepted = reportIntersectionEXT(hit.t, hit.axis < 0 ? 6u : uint(2 * hit.axis + max(hit.side, 0)));
    if (!accepted)
      found = ${prefix}next(volume, gl_ObjectRayOriginEXT, gl_ObjectRayDirectionEXT, gl_RayTmaxEXT, hit);
  }
}
