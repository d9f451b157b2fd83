#pragma once
#include "figures/layout.h"

namespace muelle::figures {

/// Gives both axes of a panel one scale: narrows the plot about its middle, and widens a range where the plot would get
/// too slim. A field fills its plot, so the plot shrinks towards its lower left corner instead.
/// \param slimmest the least width of the plot [px]
void equaliseAxes(PanelLayout& panel, bool isField, double slimmest);

/// Longer names under the x axis are turned. [px]
double widestLevelName();

/// Height of what stands below a plot: numbers or names, and the x label where there is one.
double footOf(const PanelShape& shape);

/// The x label, so far below the middle of the plot.
Label xLabelBelow(const Box& plot, double distance, double width);

/// Distance of the numbers on the y axis of a slide: not too close, nor too many. \param height of the plot
double yStepOf(const AxisShape& axis, const AxisRange& range, double height);

/// Distance of the numbers on the x axis of a slide: as close as they stay apart. \param width of the plot
double xStepOf(const AxisShape& axis, const AxisRange& range, double width);

}  // namespace muelle::figures
