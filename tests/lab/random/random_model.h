#pragma once
#include "dice.h"
#include "engine/model/model.h"

namespace muelle::lab {

/// A model drawn at random: one to six nodes in one, two or three dimensions, in a chain with springs across it (in one
/// way damped or not, one-sided, signed, or rods in their place), that resists bending, holds areas, volumes or the
/// mean of a component; hung, moved or free, over an obstacle of each shape that rubs, moves or neither; with gravity,
/// drag, and forces in pulses, with a period, or both.
engine::Model randomModel(Dice& dice);

}  // namespace muelle::lab
