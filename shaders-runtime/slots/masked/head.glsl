// A masked grid has a bit a cell, x fastest, then y, then z, and then the values of the cells that are not empty, unless all are
// alike.
