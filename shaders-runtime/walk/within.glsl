// Whether a walk is still in the sub-volume in which it began.
%if first
bool within_level(ivec3 begin, ivec3 cell) { return is_in_volume(cell); }
%else
bool within_level(ivec3 begin, ivec3 cell) { return is_same_cube(begin, cell, LEVEL_LOG2_SIDE); }
%end

