#pragma once
#include "drawing.h"

namespace muelle::plots {

/// Where a field has the value `level`: marching squares, straight through each cell of the grid, so off by the square
/// of its size. x across and y up, as in the field; a value that meets the level exactly counts as above it.
Segments contour(const Field& field, double level);

}  // namespace muelle::plots
