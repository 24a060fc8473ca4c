// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty: each is the
// number of a sub-volume.
