#include "engine/elements/dihedral/model_dihedral.h"
#include "engine/scene/table_reader.h"

namespace muelle::engine {

void ModelDihedral::readOwn(const TableReader& table, const Model& /*model*/) { theta0 = table.number("theta0", 0.0); }

}  // namespace muelle::engine
