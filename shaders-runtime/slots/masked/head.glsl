%if implied
// A masked grid has a bit a cell, x fastest, then y, then z: all that are set have the same value.
%else
// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty.
%if ranked
// Each value is followed by how many voxels come before those of its cell.
%end
%end
%if counts
// Each word of the mask is followed by how many bits the words before it have.
%end
