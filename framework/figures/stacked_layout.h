#pragma once
#include "figures/layout.h"

namespace muelle::figures {

/// Panels one below the other, with plots between the same edges; the canvas is as high as they need. The title is not
/// placed.
Layout stackedLayout(const FigureShape& figure);

}  // namespace muelle::figures
