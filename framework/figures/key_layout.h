#pragma once
#include "figures/layout.h"

namespace muelle::figures {

/// The widths of the entries of a key, in rows from the top. The first row shares its line with the y label and may be
/// empty.
using KeyRows = std::vector<std::vector<double>>;

/// Fills rows one after the other. \param width from the y label's beginning to the key's right end
KeyRows keyRows(const PanelShape& shape, double width);

/// Places the y label and the key above the panel's plot, whose place is given; the key ends at `keyRight`. Rows are
/// flush right, but where each has one entry, the entries begin one below the other.
void placeHeader(double labelLeft, double keyRight, const PanelShape& shape, const KeyRows& rows, PanelLayout& panel);

}  // namespace muelle::figures
