/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it. Those that any
/// function may hold (generic_mistakes.h) are listed where the exercise has better words for them.

#include "system_assembly.h"

#include "course/testing/random.h"
#include "course/testing/test_function.h"
#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <fmt/format.h>

namespace {

using Springs = std::vector<Spring>;

Vec3 node(const VecX& x, int i) { return x.segment<3>(3 * i); }

SparseMatrix diagonal(const VecX& entries) {
  SparseMatrix M(entries.size(), entries.size());
  for (Eigen::Index i = 0; i < entries.size(); ++i) M.insert(i, i) = entries[i];
  return M;
}

}  // namespace

// --- mass matrix ----------------------------------------------------------------------------------------------------

MUELLE_MISTAKE(systemMassMatrix, masses_interleaved, [](const VecX& m) { return diagonal(m.replicate(3, 1)); });
MUELLE_MISTAKE(systemMassMatrix, mass_once_per_node, [](const VecX& m) {
  VecX entries = VecX::Zero(3 * m.size());
  for (Eigen::Index i = 0; i < m.size(); ++i) entries[3 * i] = m[i];
  return diagonal(entries);
});
MUELLE_MISTAKE(systemMassMatrix, of_nodes, [](const VecX& m) { return diagonal(m); });
MUELLE_MISTAKE(systemMassMatrix, inverse_mass_matrix,
               [](const VecX& m) { return oracle::systemMassMatrix(m.cwiseInverse()); });
MUELLE_MISTAKE(systemMassMatrix, mean_mass,
               [](const VecX& m) { return oracle::systemMassMatrix(VecX::Constant(m.size(), m.mean())); });
MUELLE_MISTAKE(systemMassMatrix, first_mass_for_all,
               [](const VecX& m) { return oracle::systemMassMatrix(VecX::Constant(m.size(), m[0])); });
MUELLE_MISTAKE(systemMassMatrix, mass_in_thirds, [](const VecX& m) { return oracle::systemMassMatrix(m / 3); });

// --- energy ---------------------------------------------------------------------------------------------------------

namespace {

/// Hooke's springs, whatever has been given.
double hookesEnergy(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const double stretch = (xa - xb).stableNorm() - L0;
  return 0.5 * k * stretch * stretch;
}

Vec6 hookesGradient(const Vec3& xa, const Vec3& xb, double k, double L0) {
  const Vec3 r = xa - xb;
  const double L = r.stableNorm();
  Vec6 both;
  both << r, -r;
  return L > 0 ? Vec6(k * (L - L0) / L * both) : Vec6(Vec6::Zero());
}

}  // namespace

/// A sum over the springs s of what `each` says. A question that the oracle refuses throws.
#define ENERGY_MISTAKE(id, ...)                                                                            \
  MUELLE_MISTAKE(systemEnergy, id, [](const VecX& x, const Springs& springs, const SpringEnergy& energy) { \
    (void)energy;                                                                                          \
    double E = 0;                                                                                          \
    for (const Spring& s : springs) __VA_ARGS__;                                                           \
    return E;                                                                                              \
  })

ENERGY_MISTAKE(nodes_exchanged, E += energy(node(x, s.b), node(x, s.a), s.k, s.L0));
ENERGY_MISTAKE(numbers_exchanged, E += energy(node(x, s.a), node(x, s.b), s.L0, s.k));
ENERGY_MISTAKE(overwrites, E = energy(node(x, s.a), node(x, s.b), s.k, s.L0));
ENERGY_MISTAKE(wrong_block, E += energy(x.segment<3>(s.a), x.segment<3>(s.b), s.k, s.L0));
ENERGY_MISTAKE(own_law, E += hookesEnergy(node(x, s.a), node(x, s.b), s.k, s.L0));
MUELLE_COMMON_MISTAKE(systemEnergy, doubled);

// --- gradient -------------------------------------------------------------------------------------------------------

/// For each spring s, something is done with its gradient g, and the blocks toA and toB of its nodes.
#define GRADIENT_MISTAKE(id, ...)                                                                                \
  MUELLE_MISTAKE(systemGradient, id, [](const VecX& x, const Springs& springs, const SpringGradient& gradient) { \
    VecX total = VecX::Zero(x.size());                                                                           \
    for (const Spring& s : springs) {                                                                            \
      [[maybe_unused]] const Vec6 g = gradient(node(x, s.a), node(x, s.b), s.k, s.L0);                           \
      [[maybe_unused]] auto toA = total.segment<3>(3 * s.a), toB = total.segment<3>(3 * s.b);                    \
      __VA_ARGS__;                                                                                               \
    }                                                                                                            \
    return total;                                                                                                \
  })
/// The halves of another vector are added.
#define ADDED_GRADIENT_MISTAKE(id, ...) \
  GRADIENT_MISTAKE(id, const Vec6 h = __VA_ARGS__; toA += h.head<3>(); toB += h.tail<3>())

MUELLE_COMMON_MISTAKE(systemGradient, wrong_sign);
GRADIENT_MISTAKE(second_node_forgotten, toA += g.head<3>());
GRADIENT_MISTAKE(first_node_forgotten, toB += g.tail<3>());
GRADIENT_MISTAKE(second_node_subtracted, toA += g.head<3>(); toB -= g.tail<3>());
GRADIENT_MISTAKE(opposite_of_the_first, toA += g.head<3>(); toB -= g.head<3>());
GRADIENT_MISTAKE(first_half_for_both, toA += g.head<3>(); toB += g.head<3>());
GRADIENT_MISTAKE(halves_exchanged, toA += g.tail<3>(); toB += g.head<3>());
GRADIENT_MISTAKE(small_ones_dropped, if (g.norm() < 1e-9) continue; toA += g.head<3>(); toB += g.tail<3>());
GRADIENT_MISTAKE(overwrites, toA = g.head<3>(); toB = g.tail<3>());
namespace at_node_a {
GRADIENT_MISTAKE(overwrites, toA = g.head<3>(); toB += g.tail<3>());
}
namespace at_node_b {
GRADIENT_MISTAKE(overwrites, toA += g.head<3>(); toB = g.tail<3>());
}
GRADIENT_MISTAKE(smaller_number_first,
                 const Vec6 h = gradient(node(x, std::min(s.a, s.b)), node(x, std::max(s.a, s.b)), s.k, s.L0);
                 total.segment<3>(3 * std::min(s.a, s.b)) += h.head<3>();
                 total.segment<3>(3 * std::max(s.a, s.b)) += h.tail<3>());
GRADIENT_MISTAKE(wrong_block, total.segment<3>(s.a) += g.head<3>(); total.segment<3>(s.b) += g.tail<3>());
ADDED_GRADIENT_MISTAKE(nodes_exchanged, gradient(node(x, s.b), node(x, s.a), s.k, s.L0));
ADDED_GRADIENT_MISTAKE(numbers_exchanged, gradient(node(x, s.a), node(x, s.b), s.L0, s.k));
ADDED_GRADIENT_MISTAKE(own_law, hookesGradient(node(x, s.a), node(x, s.b), s.k, s.L0));

// --- accelerations --------------------------------------------------------------------------------------------------

namespace {

/// A mass for each component.
VecX spread(const VecX& m) {
  VecX all(3 * m.size());
  for (Eigen::Index i = 0; i < all.size(); ++i) all[i] = m[i / 3];
  return all;
}

}  // namespace

/// With the right gradient g and the masses M of all components.
#define ACCELERATION_MISTAKE(id, ...)                                                         \
  MUELLE_MISTAKE(systemAccelerations, id,                                                     \
                 [](const VecX& x, [[maybe_unused]] const VecX& m, const Springs& springs,    \
                    const SpringGradient& gradient, [[maybe_unused]] const VecX& F) -> VecX { \
                   const VecX g = oracle::systemGradient(x, springs, gradient);               \
                   [[maybe_unused]] const VecX M = spread(m);                                 \
                   return __VA_ARGS__;                                                        \
                 })

ACCELERATION_MISTAKE(uphill, (F + g).cwiseQuotient(M));
ACCELERATION_MISTAKE(springs_forgotten, F.cwiseQuotient(M) + 0 * g);
ACCELERATION_MISTAKE(other_forces_forgotten, -g.cwiseQuotient(M));
ACCELERATION_MISTAKE(other_forces_subtracted, (-F - g).cwiseQuotient(M));
ACCELERATION_MISTAKE(mass_missing, F - g);
ACCELERATION_MISTAKE(mass_multiplied, (F - g).cwiseProduct(M));
ACCELERATION_MISTAKE(other_forces_without_mass, F - g.cwiseQuotient(M));
ACCELERATION_MISTAKE(springs_without_mass, F.cwiseQuotient(M) - g);
ACCELERATION_MISTAKE(gravity_too, (F - g).cwiseQuotient(M) + Vec3(0, 0, -9.81).replicate(m.size(), 1));
ACCELERATION_MISTAKE(masses_interleaved, (F - g).cwiseQuotient(m.replicate(3, 1)));
ACCELERATION_MISTAKE(first_mass_for_all, (F - g) / m[0]);

// ------------------------------------------------------------------------------------------- arguments in general
// position

namespace {

using muelle::Random;
using muelle::TestFunction;

constexpr int nodes = 4;

/// The number on a spring's energy and gradient: of two digits, so that they can be read.
double someDigits(Random& random) { return std::round(10 * random.number(1.1, 2.9)) / 10; }

SpringEnergy someEnergy(Random& random) {
  const double p = someDigits(random), q = someDigits(random);
  const std::string source = fmt::format(
      "[](const Vec3& xa, const Vec3& xb, double k, double L0) {{ return k * xa.dot(Vec3({0}, {1}, 1)) - "
      "L0 * xb.dot(Vec3(1, {0}, {1})); }}",
      p, q);
  return TestFunction<double(const Vec3&, const Vec3&, double, double)>(
      source, [p, q](const Vec3& xa, const Vec3& xb, double k, double L0) {
        return k * xa.dot(Vec3(p, q, 1)) - L0 * xb.dot(Vec3(1, p, q));
      });
}

SpringGradient someGradient(Random& random) {
  const double p = someDigits(random), q = someDigits(random);
  const std::string source = fmt::format(
      "[](const Vec3& xa, const Vec3& xb, double k, double L0) {{ Vec6 g; g << k * (xa + {} * xb), "
      "L0 * (xa - {} * xb); return g; }}",
      p, q);
  return TestFunction<Vec6(const Vec3&, const Vec3&, double, double)>(
      source, [p, q](const Vec3& xa, const Vec3& xb, double k, double L0) {
        Vec6 g;
        g << k * (xa + p * xb), L0 * (xa - q * xb);
        return g;
      });
}

VecX someVector(Random& random, Eigen::Index size, double low, double high) {
  VecX numbers(size);
  for (double& number : numbers) number = random.rounded(low, high);
  return numbers;
}

/// A chain that is closed, and a diagonal: the nodes stay, so that one draw's springs fit another's.
Springs someSprings(Random& random) {
  Springs springs;
  for (const auto& [a, b] : std::vector<std::pair<int, int>>{{0, 1}, {2, 1}, {2, 3}, {3, 0}, {0, 2}}) {
    springs.push_back({a, b, random.rounded(120, 870), random.rounded(30, 90)});
  }
  return springs;
}

VecX somePlaces(Random& random) { return someVector(random, 3 * nodes, 20, 90); }
VecX someMasses(Random& random) { return someVector(random, nodes, 30, 90); }

}  // namespace

MUELLE_ARGUMENTS(systemMassMatrix, [](Random& random) {
  const VecX m = someMasses(random);
  return std::tuple(m);
});
MUELLE_ARGUMENTS(systemEnergy, [](Random& random) {
  const VecX x = somePlaces(random);
  const Springs springs = someSprings(random);
  const SpringEnergy energy = someEnergy(random);
  return std::tuple(x, springs, energy);
});
MUELLE_ARGUMENTS(systemGradient, [](Random& random) {
  const VecX x = somePlaces(random);
  const Springs springs = someSprings(random);
  const SpringGradient gradient = someGradient(random);
  return std::tuple(x, springs, gradient);
});
MUELLE_ARGUMENTS(systemAccelerations, [](Random& random) {
  const VecX x = somePlaces(random);
  const VecX m = someMasses(random);
  const Springs springs = someSprings(random);
  const SpringGradient gradient = someGradient(random);
  const VecX F = someVector(random, 3 * nodes, 3000, 9000);
  return std::tuple(x, m, springs, gradient, F);
});
