// What the sub-volume becomes whose low corner is `low` and to which `old` leads; 0: it is empty.
uint32_t edit_level_${N}(Edit &edit, uint32_t old, Voxel low) {
  uint32_t value = 0;
  switch (edit.effect(low, LEVEL_${N}_LOG2_SIDE, value)) {
  case Effect::Keep:
    return old;
  case Effect::Set:
    edit.replace(${N}, old, LEVEL_${N}_LOG2_SIDE, value);
    return filled_level_${N}(edit, value);
  case Effect::Change:
    break;
  }
  return change_level_${N}(edit, old, low);
}
