// A tree of depth 0 is one leaf.
uint locate_level(const Ray ray, uint leaf, ivec3 cell, inout Gap gap${and-faces}) {
%if last
  return ${leaf-leaf};
%else
  return locate_next(ray, load_word(leaf), cell, gap${and-face});
%end
}
