// What a voxel is: here it is there, and all have one colour.
uint colour_of(const Walk walk) { return load_word(${head,}1u); }
