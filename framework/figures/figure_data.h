#pragma once
#include "harness/figure.h"

#include <string>
#include <vector>

namespace muelle::figures {

/// A curve as gnuplot knows it.
struct Curve {
  const Series* series;
  int block;                ///< index in the data file; -1: no point to draw
  bool asPoints;            ///< markers in place of a line
  int style;                ///< number of the line style
  int markStyle;            ///< of the mark in the key: a square for cells
  std::string leaves = {};  ///< "leaves the picture at t = 0.2 s"; empty: it does not

  /// With a word where nothing is drawn or where it ends too early; empty: not in the key.
  std::string nameInKey() const;
};

/// What is drawn in a panel, in the order of the key: what was simulated before its references.
struct PanelCurves {
  std::vector<Curve> curves;
  int fieldBlock = -1;  ///< index of the field in the data file; -1: none
};

/// The data file of a figure, and what stands in it.
struct FigureData {
  std::string text;
  std::vector<PanelCurves> panels;
  int styleCount = 0;  ///< so many styles of the palette are used
};

/// The numbers of a figure; the curves point into it.
FigureData figureData(const Figure& figure);

/// The label of a panel's x axis: its own or the figure's.
const std::string& xLabelOf(const Figure& figure, const Panel& panel);

}  // namespace muelle::figures
