#pragma once
#include "engine/statics/tension_matrix.h"

namespace muelle::engine {

/// Newton's method on the positions and the unknown tensions of a shape, at most so many factorisations, steps halved
/// until they do better; `pulling` keeps tensions positive on the way. Stops at round-off or where no step helps; the
/// best shape stays.
Imbalance newtonOnTensions(TensionShape& shape, TensionMatrix& matrix, int mostFactorisations, bool pulling);

}  // namespace muelle::engine
