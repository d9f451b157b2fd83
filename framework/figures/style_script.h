#pragma once
#include "figures/figure_data.h"
#include "figures/format.h"
#include "figures/layout.h"

#include <string>

namespace muelle::figures {

/// What a script begins with: the file that it writes, the styles of all panels, and the title.
std::string headOfScript(const Figure& figure, const FigureData& data, const Layout& layout, Format format);

}  // namespace muelle::figures
