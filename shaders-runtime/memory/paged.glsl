// Of the volume's pages some are here: each lies in a slot. The first slot has zeros, for those that are not.
layout(constant_id = 4) const uint LOG2_PAGE_WORDS = 10u;
layout(constant_id = 5) const uint PAGES = 1u; // Of the volume.
layout(std430, set = 0, binding = 2) readonly restrict buffer Slots { uint words[]; };
// An entry for each page, and one for all that lies beyond them, which is never absent.
layout(std430, set = 0, binding = 4) restrict buffer PageTable { uint page_table[]; };
bool lacks_page = false;
