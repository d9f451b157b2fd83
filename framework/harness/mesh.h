#pragma once
#include "harness/node.h"
#include "harness/spring.h"

#include <vector>

namespace muelle {

/// Nodes and the springs between them.
struct Mesh {
  std::vector<Node> nodes;
  std::vector<Spring> springs;
};

/// What a generator gives every spring and the whole: total mass M is lumped, m = M / n (slide "Masa/Inercia").
struct Material {
  double M = 1.0;    ///< total mass [kg]
  double k = 100.0;  ///< stiffness of each spring [N/m]
};

/// n nodes on a line from `start` to `end`, n - 1 springs at rest. n >= 2.
Mesh chain(int n, const Vec3& start, const Vec3& end, const Material& material);

/// nx by ny nodes in the plane z = 0 from the origin, `spacing` [m] apart; springs along the edges and, with `shear`,
/// both diagonals of each cell, all at rest. Node (i, j) has index j * nx + i. nx, ny >= 2.
Mesh grid(int nx, int ny, double spacing, bool shear, const Material& material);

/// Three nodes and the springs 01, 12, 20, at rest at the given corners.
Mesh triangle(const Vec3& x0, const Vec3& x1, const Vec3& x2, const Material& material);

}  // namespace muelle
