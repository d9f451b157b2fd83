// attack: places its mistakes in headers of the system, marked as such; expect: zero points
#include "spring_1d.h"
# 40 "/usr/include/c++/12/bits/stl_vector.h" 1 3 4
int broken = "text";
# 100 "../eigen/Eigen/src/Core/Matrix.h" 1 3
double lumpedMass(double M, int n) { return missing; }
