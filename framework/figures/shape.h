#pragma once
#include "figures/figure_data.h"
#include "figures/layout.h"

namespace muelle::figures {

/// Measures a figure: what its layout has to know of its numbers and texts.
FigureShape shapeOf(const Figure& figure, const FigureData& data);

}  // namespace muelle::figures
