#include "engine/elements/area/model_area.h"
#include "engine/model/model.h"
#include "engine/scene/table_reader.h"

namespace muelle::engine {

/// Where the scene does not say, an area wants to be as it is, seen along its own normal.
void ModelArea::readOwn(const TableReader& table, const Model& model) {
  if (model.dimension == 3) {
    normal = table.has("normal") ? table.direction("normal") : normalIn(model);
    if (normal.isZero(0.0)) table.failHere("the triangle has no normal; give 'normal'");
  }
  A0 = table.number("A0", areaIn(model));
}

}  // namespace muelle::engine
