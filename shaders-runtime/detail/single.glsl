uint sample_level_N(uint leaf) { return sample_NEXT(load_word(leaf)); }

