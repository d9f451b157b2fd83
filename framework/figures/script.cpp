#include "figures/script.h"

#include "figures/figure_data.h"
#include "figures/layout.h"
#include "figures/panel_script.h"
#include "figures/shape.h"
#include "figures/style_script.h"

namespace muelle {

FigureText figureText(const Figure& figure, Format format) {
  figures::FigureData data = figures::figureData(figure);
  const figures::Layout layout = figures::layOut(figures::shapeOf(figure, data));
  std::string script = figures::headOfScript(figure, data, layout, format);
  for (std::size_t i = 0; i < layout.panels.size(); ++i) {
    script += figures::panelScript(figure, i, data.panels[i], layout);
  }
  script += "unset multiplot\nunset output\n";
  return {std::move(data.text), std::move(script)};
}

}  // namespace muelle
