// The layers of all levels, counted from the root. Of a level, the lowest that has a node around the traversal's cell: a leaf may
// stand above the others.
struct Lowest {
  int layer[LEVELS];
};
