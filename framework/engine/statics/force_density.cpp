#include "engine/statics/force_density.h"

#include "engine/solve/sparse_ldlt.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// Each is one linear system; eight bring a chain five times as long as its span to 1e-5 of its length.
constexpr int passes = 8;

/// Positions that the fixed nodes give, and what the loads add to them where all densities are multiplied by 1.
struct Net {
  Vector held, sag;  // [m], [m N]
};

/// Nothing where the system is singular.
std::optional<Net> solveNet(TensionShape& shape, const std::vector<double>& density) {
  Triplets entries;
  Vector pull = Vector::Zero(shape.size);
  for (std::size_t j = 0; j < shape.springs.size(); ++j) {
    const TensionSpring& spring = shape.springs[j];
    const double q = density[j];
    for (int i = 0; i < shape.dimension; ++i) {
      if (spring.a >= 0) entries.emplace_back(spring.a + i, spring.a + i, q);
      if (spring.b >= 0) entries.emplace_back(spring.b + i, spring.b + i, q);
      if (spring.a >= 0 && spring.b >= 0) {
        entries.emplace_back(spring.a + i, spring.b + i, -q);
        entries.emplace_back(spring.b + i, spring.a + i, -q);
      } else if (spring.a >= 0) {
        pull[spring.a + i] += q * spring.fixedB[i];
      } else {
        pull[spring.b + i] += q * spring.fixedA[i];
      }
    }
  }
  Eigen::SparseMatrix<double> D(shape.size, shape.size);
  D.setFromTriplets(entries.begin(), entries.end());
  ++shape.work.factorisations;
  SparseLdlt ldlt(SparseLdlt::Order::LeastFill);
  ldlt.analyse(D);
  if (!ldlt.factorise(D)) return std::nullopt;
  const Vector pivots = ldlt.pivots();
  if (!(pivots.minCoeff() > 1e-12 * pivots.maxCoeff())) return std::nullopt;
  Net net;
  ldlt.solve(pull, net.held);
  ldlt.solve(shape.otherForce, net.sag);
  shape.work.solves += 2;
  if (!net.held.allFinite() || !net.sag.allFinite()) return std::nullopt;
  return net;
}

/// Puts the nodes where densities c times those given hold the loads; the sum of L - L0 - T/k there [m].
double excessLength(TensionShape& shape, const Net& net, const std::vector<double>& density, double c) {
  shape.hi = net.held + net.sag / c;
  double sum = 0.0;
  for (std::size_t j = 0; j < shape.springs.size(); ++j) {
    TensionSpring& spring = shape.springs[j];
    Vec3 d = Vec3::Zero();
    for (int i = 0; i < shape.dimension; ++i) {
      d[i] = (spring.a < 0 ? spring.fixedA[i] : shape.hi[spring.a + i]) -
             (spring.b < 0 ? spring.fixedB[i] : shape.hi[spring.b + i]);
    }
    spring.L = d.norm();
    sum += spring.L * (1.0 - c * density[j] / spring.k) - spring.L0;
  }
  return sum;
}

/// Puts the nodes where force densities c times those given hold the loads, c such that lengths are right on the
/// average; returns c [N], or nothing where that system is singular.
std::optional<double> hang(TensionShape& shape, const std::vector<double>& density) {
  const std::optional<Net> net = solveNet(shape, density);
  if (!net) return std::nullopt;
  shape.lo.setZero();
  const auto excess = [&](double c) { return excessLength(shape, *net, density, c); };
  // Bisection of log c: more force makes them shorter and stretches them more.
  double low = 1e-12 * shape.load, high = shape.load;
  while (excess(high) > 0.0 && high < 1e30 * shape.load) high *= 16.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = std::sqrt(low * high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  excess(high);
  return high;
}

/// Makes unknowns of all tensions, with the values of the densities c times those given.
void takeTensions(TensionShape& shape, const std::vector<double>& density, double c) {
  double across = 0.0;
  for (const double q : density) across = std::max(across, c * q);
  shape.typicalLength = 0.0;
  for (std::size_t j = 0; j < density.size(); ++j) {
    TensionSpring& spring = shape.springs[j];
    spring.mixed = true;
    spring.rho = std::min(keptStiffness * across, 0.5 * spring.k);
    spring.S = c * density[j] * spring.L - spring.rho * (spring.L - spring.L0);
    shape.typicalLength += spring.L0 / static_cast<double>(density.size());
  }
}

}  // namespace

bool placeByForceDensity(TensionShape& shape) {
  if (shape.springs.empty() || !(shape.load > 0.0)) return false;
  std::vector<double> density;
  for (const TensionSpring& spring : shape.springs) {
    if (!(spring.L0 > 0.0) || spring.k == 0.0) return false;
    density.push_back(1.0 / spring.L0);
  }
  std::optional<double> c;
  for (int i = 0; i < passes; ++i) {
    c = hang(shape, density);
    if (!c || !(*c > 0.0)) return false;
    if (i + 1 == passes) break;
    // A spring that came out too long needs more force for its length.
    for (std::size_t j = 0; j < density.size(); ++j) {
      const TensionSpring& spring = shape.springs[j];
      density[j] *= spring.L / (spring.L0 + *c * density[j] * spring.L / spring.k);
    }
  }
  takeTensions(shape, density, *c);
  shape.measure();
  return true;
}

}  // namespace muelle::engine
