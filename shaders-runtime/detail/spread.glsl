// How wide a ray's cone grows for each voxel of its length; what looks smaller is not looked into. 0: nothing is small.
layout(constant_id = 1) const float SPREAD = 0.0;
