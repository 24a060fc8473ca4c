// Count the lookups of each ray: not here.
const bool COUNT_LOOKUPS = false;
// Exact arithmetic is at hand, and settles what float32 leaves open.
const bool SETTLES = true;
%if keeps-sums
// Rays that begin far away are moved near the volume, by sums that are rounded once and not put in another order.
const bool COMES_NEAR = true;
%else
// Nothing keeps a compiler of this language from putting sums in another order, by which rays from far away come near: they are
// settled instead.
const bool COMES_NEAR = false;
%end

%if paged
// A word was looked for that is not here. From then on all words are 0: what would be asked for next might follow from it.
bool lacks_page = false;

%if granules
// A word of what begins at a granule, of ${granule-words} words.
uint load_word(uint granule, uint offset) {
  uint word = 0u;
  lacks_page = lacks_page || !VOXC_FIND(volume, (VOXC_INDEX(granule) << ${log2-granule}) + offset, word);
  return lacks_page ? 0u : word;
}

uint load_word(uint granule) { return load_word(granule, 0u); }
%else
uint load_word(uint offset) {
  uint word = 0u;
  lacks_page = lacks_page || !VOXC_FIND(volume, offset, word);
  return lacks_page ? 0u : word;
}
%end
%else
%if granules
// A word of what begins at a granule, of ${granule-words} words.
uint load_word(uint granule, uint offset) { return VOXC_LOAD(volume, (VOXC_INDEX(granule) << ${log2-granule}) + offset); }

uint load_word(uint granule) { return load_word(granule, 0u); }
%else
uint load_word(uint offset) { return VOXC_LOAD(volume, offset); }
%end
%end
