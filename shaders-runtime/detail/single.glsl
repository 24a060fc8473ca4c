uint sample_level_${N}(uint leaf) { return sample_${NEXT}(load_word(leaf)); }

