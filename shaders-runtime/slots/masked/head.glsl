// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty, unless all are
// alike. Where values are ranked, each is followed by how many voxels come before those of its cell. Each word of the mask of
// a large grid is followed by how many bits the words before it have.
