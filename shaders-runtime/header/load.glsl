// Count the lookups of each ray: not here.
const bool COUNT_LOOKUPS = false;
// Exact arithmetic is at hand, and settles what float32 leaves open.
const bool SETTLES = true;

%if granules
// A word of what begins at a granule, of ${granule-words} words.
uint load_word(uint granule, uint offset) { return VOXC_LOAD(volume, (VOXC_INDEX(granule) << ${log2-granule}) + offset); }

uint load_word(uint granule) { return load_word(granule, 0u); }
%else
uint load_word(uint offset) { return VOXC_LOAD(volume, offset); }
%end
