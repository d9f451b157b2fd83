#pragma once

namespace muelle {

/// True for what only memory holds that nobody has written to: the pattern with which students' local variables and
/// fresh heap memory are filled (bytes of 0xFE; 0xAA or 0xFF with clang), the quiet NaN with which Eigen's objects are,
/// and what arithmetic makes of the pattern, whose size of 5e303 no physics has.
bool isFill(double value);

}  // namespace muelle
