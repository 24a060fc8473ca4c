// Which reflections a node stays equal under stand, a bit for each, above its masks while it has not found its place.
constexpr unsigned kSymmetriesAt_${N} = 2 * LEVEL_${N}_CHILDREN;
constexpr unsigned kPlaceBits_${N} = 29;

// What leads to a node when all around it is reflected: of the reflections that come to the same, the least.
uint32_t reflected_level_${N}_reference(uint32_t reference, uint32_t symmetries, unsigned reflection) {
  const unsigned own = reference >> kPlaceBits_${N} ^ reflection;
  unsigned least = own;
  for (unsigned other = 1; other < 8; ++other)
    if ((symmetries >> other & 1) != 0 && (own ^ other) < least)
      least = own ^ other;
  return (reference & ((1u << kPlaceBits_${N}) - 1)) | least << kPlaceBits_${N};
}

// Fills in the words of a node with these children, reflected, and returns how many.
uint64_t fill_level_${N}_node(const Children<LEVEL_${N}_CHILDREN> &children, unsigned reflection, uint32_t *words) {
  uint64_t count = 1;
  words[0] = 0;
  for (unsigned place = 0; place < LEVEL_${N}_CHILDREN; ++place) {
    const unsigned i = place ^ reflection;
    if ((children.filled >> i & 1) == 0)
      continue;
    words[0] |= 1u << place;
    if (children.is_leaf(i))
      words[0] |= 1u << (LEVEL_${N}_CHILDREN + place);
    else
      words[count++] = reflected_level_${N}_reference(children.values[i], children.masks[i][0] >> kSymmetriesAt_${N}, reflection);
  }
  return count;
}

// True if the words come before the others in the order by which one of all reflections is chosen.
bool is_before_level_${N}(const uint32_t *words, const uint32_t *others, uint64_t count) {
  for (uint64_t i = 0; i < count; ++i)
    if (words[i] != others[i])
      return words[i] < others[i];
  return false;
}

// Of the eight reflections of a node, the one whose words come first.
struct Mirrored_${N} {
  uint32_t words[1 + LEVEL_${N}_CHILDREN];
  uint64_t count;
  unsigned reflection;     // By which it came about,
  uint32_t symmetries = 1; // and those that change nothing, a bit for each.
};

Mirrored_${N} mirror_level_${N}_node(const Children<LEVEL_${N}_CHILDREN> &children) {
  uint32_t own[1 + LEVEL_${N}_CHILDREN];
  Mirrored_${N} first;
  first.count = fill_level_${N}_node(children, 0, own);
  first.reflection = 0;
  for (uint64_t i = 0; i < first.count; ++i)
    first.words[i] = own[i];
  for (unsigned reflection = 1; reflection < LEVEL_${N}_CHILDREN; ++reflection) {
    uint32_t words[1 + LEVEL_${N}_CHILDREN];
    fill_level_${N}_node(children, reflection, words);
    if (!is_before_level_${N}(own, words, first.count) && !is_before_level_${N}(words, own, first.count))
      first.symmetries |= 1u << reflection;
    if (!is_before_level_${N}(words, first.words, first.count))
      continue;
    first.reflection = reflection;
    for (uint64_t i = 0; i < first.count; ++i)
      first.words[i] = words[i];
  }
  return first;
}

// Writes a node, unless it or a reflection of it is written already. Its masks say which children are leaves, and that is all
// there is to say of them.
Node write_level_${N}_node(Build &build, const Children<LEVEL_${N}_CHILDREN> &children) {
  if (children.filled == 0)
    return {};
  const Mirrored_${N} mirrored = mirror_level_${N}_node(children);
  Node node = children.parent();
  node.masks[0] |= mirrored.symmetries << kSymmetriesAt_${N};
  node.value = build.intern(${N}, mirrored.words, mirrored.count);
  if (node.value != 0) // Else building has failed.
    node.value |= mirrored.reflection << kPlaceBits_${N};
  return node;
}
%if looks-ahead

// Tells of the nodes above the voxels of a brick before they are written, so that what they are compared with is near then.
void look_ahead_level_${N}(Build &build, const Brick &brick) {
  for (unsigned first = 0; first < 512; first += LEVEL_${N}_CHILDREN) {
    if (brick.filled_from(first, LEVEL_${N}_CHILDREN) == 0)
      continue;
    Children<LEVEL_${N}_CHILDREN> children;
    children.put_voxels(brick, first);
    const Mirrored_${N} mirrored = mirror_level_${N}_node(children);
    build.announce(${N}, mirrored.words, mirrored.count);
  }
  build.end_announcing(${N});
}
%end
