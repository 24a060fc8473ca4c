// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty.
// A value is the number of a sub-volume.
%if ranked
// In the bits behind them all, ${count-bits} each, stands how many voxels come before those of each ${what-is-counted}.
%end
%if counts
// Each word of the mask is followed by how many bits the words before it have.
%end
