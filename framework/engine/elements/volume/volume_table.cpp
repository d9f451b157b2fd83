#include "engine/elements/volume/model_volume.h"
#include "engine/scene/table_reader.h"

namespace muelle::engine {

/// Where the scene does not say, a volume wants to be as it is.
void ModelVolume::readOwn(const TableReader& table, const Model& model) { V0 = table.number("V0", volumeIn(model)); }

}  // namespace muelle::engine
