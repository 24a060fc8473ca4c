// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty: each is the
// number of a sub-volume. Each word of the mask of a large grid is followed by how many bits the words before it have. Where
// cells are ranked, the bits behind all values tell how many voxels come before those of a cell, or of an octant of cells.
