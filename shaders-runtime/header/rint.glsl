#version 460
// voxc_format.rint: where rays meet volumes of the format FORMAT, for boxes in acceleration structures. It needs
// voxc_format.h beside it, and voxc_format.rchit, or another closest-hit shader with this attribute, in its hit group.
#extension GL_EXT_ray_tracing : require
#extension GL_EXT_buffer_reference : require
#extension GL_GOOGLE_include_directive : require

// The address of a volume's words stands in the record of the hit group, behind its handle.
layout(buffer_reference, std430, buffer_reference_align = 4) readonly buffer Words { uint words[]; };
layout(shaderRecordEXT, std430) buffer Record { Words volume; };

#define VOXC_VOLUME Words
#define VOXC_LOAD(volume, index) volume.words[index]
#include "voxc_format.h"

hitAttributeEXT voxc_format_Hit reached;

// Objects are in voxels: a box from 0 to voxc_format_VOLUME_SIZE holds the volume, and an instance's transform leads from there to
// the world. A hit's kind is its face: twice its axis, and 1 more for the high one; 6 where the ray begins in the voxel. An any-hit
// shader that ignores a voxel lets the ray go on to the next.
void main() {
  voxc_format_Hit hit;
  bool found = voxc_format_closest(volume, gl_ObjectRayOriginEXT, gl_ObjectRayDirectionEXT, gl_RayTminEXT, gl_RayTmaxEXT, hit);
  bool accepted = false;
  while (found && !accepted) {
    reached = hit;
    accepted = reportIntersectionEXT(hit.t, hit.axis < 0 ? 6u : uint(2 * hit.axis + max(hit.side, 0)));
    if (!accepted)
      found = voxc_format_next(volume, gl_ObjectRayOriginEXT, gl_ObjectRayDirectionEXT, gl_RayTmaxEXT, hit);
  }
}
