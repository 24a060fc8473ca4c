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

// A node's words, and by what its reflections are told apart: offsets differ from part to part of a volume, and so in place of
// a reference stand the number of what it leads to, which says what that is and not where, and how it is read.
struct Reflected_${N} {
  uint32_t words[1 + LEVEL_${N}_CHILDREN];
  uint32_t key[1 + 2 * LEVEL_${N}_CHILDREN];
  unsigned count = 1; // Of the words.
};

// The node with these children, reflected. Where children count voxels in other levels, they have their numbers here.
Reflected_${N} reflect_level_${N}_node(const Children<LEVEL_${N}_CHILDREN> &children, unsigned reflection) {
  Reflected_${N} node;
  node.words[0] = 0;
  for (unsigned place = 0; place < LEVEL_${N}_CHILDREN; ++place) {
    const unsigned i = place ^ reflection;
    if ((children.filled >> i & 1) == 0)
      continue;
    node.words[0] |= 1u << place;
    if (children.is_leaf(i)) {
      node.words[0] |= 1u << (LEVEL_${N}_CHILDREN + place);
      continue;
    }
    const uint32_t symmetries = children.masks[i][0] >> kSymmetriesAt_${N};
    const uint32_t reference = reflected_level_${N}_reference(children.values[i], symmetries, reflection);
    node.key[2 * node.count - 1] = children.voxels[i];
    node.key[2 * node.count] = reference >> kPlaceBits_${N};
    node.words[node.count++] = reference;
  }
  node.key[0] = node.words[0];
  return node;
}

// True if a reflection comes before another in the order by which one of all is chosen.
bool is_before_level_${N}(const Reflected_${N} &node, const Reflected_${N} &other) {
  for (unsigned i = 0; i < 2 * node.count - 1; ++i)
    if (node.key[i] != other.key[i])
      return node.key[i] < other.key[i];
  return false;
}

bool are_equal_level_${N}(const Reflected_${N} &node, const Reflected_${N} &other) {
  for (unsigned i = 0; i < node.count; ++i)
    if (node.words[i] != other.words[i])
      return false;
  return true;
}

// Of the eight reflections of a node, the one that comes first.
struct Mirrored_${N} {
  Reflected_${N} node;
  unsigned reflection = 0; // By which it came about,
  uint32_t symmetries = 1; // and those that change nothing, a bit for each.

  // A number of what it is.
  uint32_t number() const {
    uint32_t mixed = 0;
    for (unsigned i = 0; i < 2 * node.count - 1; ++i) {
      mixed = (mixed ^ node.key[i]) * 0x9e3779b1u;
      mixed ^= mixed >> 15;
    }
    return mixed;
  }
};

Mirrored_${N} mirror_level_${N}_node(const Children<LEVEL_${N}_CHILDREN> &children) {
  const Reflected_${N} own = reflect_level_${N}_node(children, 0);
  Mirrored_${N} first = {own};
  for (unsigned reflection = 1; reflection < LEVEL_${N}_CHILDREN; ++reflection) {
    const Reflected_${N} node = reflect_level_${N}_node(children, reflection);
    if (are_equal_level_${N}(node, own))
      first.symmetries |= 1u << reflection;
    if (!is_before_level_${N}(node, first.node))
      continue;
    first.node = node;
    first.reflection = reflection;
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
  node.voxels = mirrored.number();
  node.value = build.intern(${N}, mirrored.node.words, mirrored.node.count);
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
    build.announce(${N}, mirrored.node.words, mirrored.node.count);
  }
  build.end_announcing(${N});
}
%end
