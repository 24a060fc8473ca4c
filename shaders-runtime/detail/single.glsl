uint sample_level(uint leaf) { return sample_next(load_word(leaf)); }
