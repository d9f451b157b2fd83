#pragma once
#include "figures/axis.h"

#include <optional>
#include <vector>

/// \file
/// Where the parts of a figure lie: pure geometry, which knows the widths of texts but no text. All in pixels, from the
/// top left corner of the canvas.

namespace muelle::figures {

/// An axis of a panel before it is placed.
struct AxisShape {
  AxisRange range;
  bool logarithmic = false;
  std::optional<double> names = {};  ///< width of the longest name, where names stand in place of numbers
  std::size_t rows = 0;              ///< number of these names
};

/// What a panel asks room for.
struct PanelShape {
  AxisShape x, y;
  bool equalAxes = false;              ///< one scale on both axes
  double yLabel = 0;                   ///< width; 0: none
  std::optional<double> xLabel = {};   ///< width; empty where the panel below has the same
  double heading = 0;                  ///< width in its full size; 0: none. For slides
  std::vector<double> key = {};        ///< width of each entry: a sample of the curve and its name
  std::optional<double> colours = {};  ///< of a field: width of the label of its colour scale
};

/// What a figure asks room for.
struct FigureShape {
  int columns = 0;   ///< of a slide; 0: panels stacked on one x axis
  double title = 0;  ///< width in sizes of its font
  std::vector<PanelShape> panels;
};

struct Box {
  double left, right, top, bottom;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
};

enum class Side { Left, Centre, Right };

/// A line of text, or an entry of the key.
struct Label {
  double x = 0;  ///< of the side that is given
  double y = 0;  ///< of the middle of its height
  double width = 0;
  Side side = Side::Left;

  /// The room it takes: a row high.
  Box box() const;
};

/// Where the parts of a panel lie.
struct PanelLayout {
  Box plot;
  AxisRange x, y;  ///< those asked for, or wider where equal axes fill the plot
  Label yLabel;
  std::optional<Label> xLabel;
  std::vector<Label> key;  ///< in the order of the entries; each begins with its sample
  // Of a slide:
  std::optional<Label> heading;
  double headingSize = 0;  ///< of its font
  double xStep = 0;        ///< distance of the numbers on the x axis, a factor on a logarithmic one
  double yStep = 0;
  bool turnsXNames = false;  ///< they are too long to stand side by side
  std::optional<Box> colourScale;
  Label colourLabel;
};

/// Where the parts of a figure lie.
struct Layout {
  double width = 0;
  double height = 0;
  Label title;
  double titleSize = 0;  ///< of its font
  std::vector<PanelLayout> panels;
};

/// Lays a figure out. Stacked panels have plots of one width, and the canvas grows with them; a slide is 16 : 9 and its
/// rows of plots share what titles, keys and labels leave. Equal axes keep their scale by a narrower plot.
Layout layOut(const FigureShape& figure);

}  // namespace muelle::figures
