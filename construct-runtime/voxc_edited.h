// voxc_edited.h: edits of a sub-volume, whatever its level is made of.
#pragma once

#include "voxc_edit.h"

namespace voxc::construct {

template <typename Level> struct Edited {
  /// What the sub-volume becomes whose low corner is `low` and to which `old` leads; 0: it is empty.
  static uint32_t edit(Edit &edit, uint32_t old, Voxel low) {
    uint32_t value = 0;
    switch (edit.effect(low, Level::LOG2_SIDE, value)) {
    case Effect::Keep:
      return old;
    case Effect::Set:
      edit.replace(Level::NUMBER, old, Level::LOG2_SIDE, value);
      return filled(edit, value);
    case Effect::Change:
      break;
    }
    return Level::Editing::change(edit, old, low);
  }

  /// What leads to a sub-volume of voxels of one value; 0 of empty ones.
  static uint32_t filled(Edit &edit, uint32_t value) {
    return edit.filled(Level::NUMBER, value, Level::Editing::fill);
  }
};

} // namespace voxc::construct
