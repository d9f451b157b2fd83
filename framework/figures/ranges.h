#pragma once
#include "figures/axis.h"
#include "harness/figure.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace muelle::figures {

/// What the axes of a panel show, as far as the data and the figure's author decide it.
struct PanelRanges {
  AxisRange x, y;
};

/// Whether the panel's x axis is logarithmic, by itself or with the figure's.
bool hasLogX(const Figure& figure, const Panel& panel);

/// Index of the first point of the curve that lies beyond what the panel's expectations allow to be shown; none when
/// all can be seen.
std::optional<std::size_t> exitOf(const Series& series, const Figure& figure, const Panel& panel);

/// The ranges of each panel. Stacked panels share their x axis; a slide's have their own.
std::vector<PanelRanges> rangesOf(const Figure& figure);

}  // namespace muelle::figures
