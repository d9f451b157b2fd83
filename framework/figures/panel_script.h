#pragma once
#include "figures/figure_data.h"
#include "figures/layout.h"

#include <cstddef>
#include <string>

namespace muelle::figures {

/// The lines that draw one panel of a figure where the layout has put it.
std::string panelScript(const Figure& figure, std::size_t index, const PanelCurves& drawn, const Layout& layout);

}  // namespace muelle::figures
