#include "figures/layout.h"

#include "figures/measures.h"
#include "figures/slide_layout.h"
#include "figures/stacked_layout.h"

#include <algorithm>

namespace muelle::figures {

Box Label::box() const {
  const double left = side == Side::Left ? x : side == Side::Right ? x - width : x - 0.5 * width;
  return {left, left + width, y - 0.5 * rowHeight, y + 0.5 * rowHeight};
}

namespace {

/// The title, smaller when it is long, so that it stays on the canvas.
void placeTitle(double width, Layout& layout) {
  constexpr double margin = 20;
  constexpr double usual = 21, least = 10;
  layout.titleSize = std::clamp((canvasWidth - 2 * margin) / width, least, usual);
  layout.title = {margin, 32, width * layout.titleSize, Side::Left};
}

}  // namespace

Layout layOut(const FigureShape& figure) {
  Layout layout = figure.columns > 0 ? slideLayout(figure) : stackedLayout(figure);
  layout.width = canvasWidth;
  placeTitle(figure.title, layout);
  return layout;
}

}  // namespace muelle::figures
