#pragma once
#include "figures/layout.h"

namespace muelle::figures {

/// Panels in columns on a canvas of 16 : 9, in rows of plots of equal height; in a row, what stands above and below the
/// plots is as high as the highest needs. The title is not placed.
Layout slideLayout(const FigureShape& figure);

}  // namespace muelle::figures
