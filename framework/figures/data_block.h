#pragma once
#include "harness/figure.h"

#include <string>

namespace muelle {

/// The lines "x y" of a curve with twelve digits; what cannot be drawn becomes one blank line, a gap for gnuplot.
/// A curve of more than 4000 points is thinned to what a screen can show: where x never falls, the first, lowest,
/// highest and last point of each of 800 equal stretches of x; on any other path, the points that lie apart by more
/// than 1/2000 of its extent. Empty when no point can be drawn.
std::string dataBlock(const Series& series, bool logX, bool logY);

/// The lines "x y dx dy" of arrows; those with a number that is not finite are left out.
std::string arrowBlock(const Series& series);

/// The lines "x y value" of a field, a blank line after each row.
std::string fieldBlock(const Field& field);

}  // namespace muelle
