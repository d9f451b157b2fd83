#include "figures/key_layout.h"

#include "figures/measures.h"

#include <algorithm>

namespace muelle::figures {

KeyRows keyRows(const PanelShape& shape, double width) {
  KeyRows rows(1);
  double room = width - shape.yLabel - entryGap;
  for (const double entry : shape.key) {
    if (entry + entryGap > room) {
      rows.emplace_back();
      room = width - labelIndent;
    }
    room -= entry + entryGap;
    rows.back().push_back(entry);
  }
  return rows;
}

namespace {

/// Where the entries of a key with one a row begin; empty where rows stand for themselves.
std::optional<double> commonBeginning(double labelLeft, double keyRight, double yLabel, const KeyRows& rows) {
  double widest = 0;
  for (const std::vector<double>& row : rows) {
    if (row.size() > 1) return std::nullopt;
    for (const double entry : row) widest = std::max(widest, entry);
  }
  const double x = keyRight - widest;
  const double label = rows.front().empty() ? 0.0 : yLabel + entryGap;
  return x < labelLeft + label ? std::nullopt : std::optional(x);
}

double beginningOf(const std::vector<double>& row, double labelLeft, double keyRight) {
  double x = keyRight + entryGap;
  for (const double entry : row) x -= entry + entryGap;
  return std::max(x, labelLeft);  // an entry wider than the canvas shows its beginning
}

}  // namespace

void placeHeader(double labelLeft, double keyRight, const PanelShape& shape, const KeyRows& rows, PanelLayout& panel) {
  const double firstRow = panel.plot.top - headerFoot - rowHeight * (static_cast<double>(rows.size()) - 0.5);
  // A plot that equal scales have made slim begins further right than the key has been given room from.
  const double keyLeft = rows.front().empty() ? keyRight : beginningOf(rows.front(), 0.0, keyRight);
  panel.yLabel = {std::min(labelLeft, std::max(0.0, keyLeft - entryGap - shape.yLabel)), firstRow, shape.yLabel,
                  Side::Left};
  const std::optional<double> common = commonBeginning(labelLeft, keyRight, shape.yLabel, rows);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    double x = common ? *common : beginningOf(rows[i], labelLeft, keyRight);
    for (const double entry : rows[i]) {
      panel.key.push_back({x, firstRow + rowHeight * static_cast<double>(i), entry, Side::Left});
      x += entry + entryGap;
    }
  }
}

}  // namespace muelle::figures
