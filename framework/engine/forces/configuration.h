#pragma once

namespace muelle::engine {

/// Where all nodes are, in the numbering and the layout of a built model. z are the internal variables of the whole
/// model.
struct Configuration {
  double t = 0.0;             ///< [s]
  const double* x = nullptr;  ///< [m]
  const double* v = nullptr;  ///< [m/s]
  const double* z = nullptr;
};

}  // namespace muelle::engine
