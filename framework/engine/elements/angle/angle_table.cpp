#include "engine/elements/angle/model_angle.h"
#include "engine/scene/table_reader.h"

namespace muelle::engine {

void ModelAngle::readOwn(const TableReader& table, const Model& /*model*/) { theta0 = table.number("theta0", 0.0); }

}  // namespace muelle::engine
