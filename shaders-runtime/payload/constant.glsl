// What a voxel is: here it is there, and all have one colour.
uint colour_of(const Traversal traversal) { return load_word_at(0u, 1u); }
