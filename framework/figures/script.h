#pragma once
#include "figures/format.h"
#include "harness/figure.h"

#include <string>

namespace muelle {

/// The two files from which gnuplot draws a figure.
struct FigureText {
  std::string data;  ///< id.dat: a block of "x y" lines for each curve, two blank lines apart; one blank line is a gap
  std::string script;  ///< id.gp: reads id.dat, writes id.svg (.pdf, .png)
};

/// Data and script of a figure, whose texts are plain already. Long curves are thinned: see dataBlock().
FigureText figureText(const Figure& figure, Format format = Format::Svg);

}  // namespace muelle
