/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it.

#include "stiffness.h"

#include "course/testing/random.h"
#include "engine/solve/dense.h"
#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <limits>

namespace {

using muelle::MatX;
using Springs = std::vector<Spring>;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

/// A spring with what its Hessian is made of.
struct Stretched {
  Vec3 r;
  double L, k, L0;

  Stretched(const Vec3& xa, const Vec3& xb, double stiffness, double rest)
      : r(xa - xb), L(r.stableNorm()), k(stiffness), L0(rest) {}
  Vec3 n() const { return r / L; }
  double T() const { return k * (L - L0); }
  Mat3 along() const { return n() * n().transpose(); }
  Mat3 across() const { return Mat3::Identity() - along(); }
};

Mat6 blocks(const Mat3& aa, const Mat3& ab, const Mat3& ba, const Mat3& bb) {
  Mat6 K;
  K << aa, ab, ba, bb;
  return K;
}
Mat6 blocks(const Mat3& A) { return blocks(A, -A, -A, A); }

Mat3 identity() { return Mat3::Identity(); }

}  // namespace

// --- springHessian --------------------------------------------------------------------------------------------------

/// A block A that is wrong; where the nodes coincide the right one stands.
#define BLOCK_MISTAKE(id, ...)                                                                        \
  MUELLE_MISTAKE(springHessian, id, [](const Vec3& xa, const Vec3& xb, double k, double L0) -> Mat6 { \
    const Stretched s(xa, xb, k, L0);                                                                 \
    return blocks(s.L > 0 ? Mat3(__VA_ARGS__) : Mat3(k * identity()));                                \
  })

BLOCK_MISTAKE(geometric_forgotten, k* s.along());
BLOCK_MISTAKE(material_forgotten, s.T() / s.L * s.across());
BLOCK_MISTAKE(rest_length_forgotten, k* identity());
BLOCK_MISTAKE(geometric_sign, k* s.along() - s.T() / s.L * s.across());
BLOCK_MISTAKE(not_projected, k* s.along() + s.T() / s.L * identity());
BLOCK_MISTAKE(tension_not_over_length, k* s.along() + s.T() * s.across());
BLOCK_MISTAKE(projections_exchanged, k* s.across() + s.T() / s.L * s.along());
BLOCK_MISTAKE(not_normalised, k* s.r* s.r.transpose() + s.T() / s.L * (identity() - s.r * s.r.transpose()));
namespace along_the_spring {
BLOCK_MISTAKE(not_normalised, k* s.r* s.r.transpose() + s.T() / s.L * s.across());
}
namespace across_the_spring {
BLOCK_MISTAKE(not_normalised, k* s.along() + s.T() / s.L * (identity() - s.r * s.r.transpose()));
}
BLOCK_MISTAKE(compression_left_out, k* s.along() + std::max(0.0, s.T()) / s.L * s.across());

#define HESSIAN_MISTAKE(id, ...)                                                                      \
  MUELLE_MISTAKE(springHessian, id, [](const Vec3& xa, const Vec3& xb, double k, double L0) -> Mat6 { \
    const Mat3 A = oracle::springHessian(xa, xb, k, L0).topLeftCorner<3, 3>();                        \
    const Mat3 none = Mat3::Zero();                                                                   \
    (void)none;                                                                                       \
    return blocks(__VA_ARGS__);                                                                       \
  })

HESSIAN_MISTAKE(coupling_sign, A, A, A, A);
namespace in_the_rows_of_a {
HESSIAN_MISTAKE(coupling_sign, A, A, -A, A);
}
namespace in_the_rows_of_b {
HESSIAN_MISTAKE(coupling_sign, A, -A, A, A);
}
HESSIAN_MISTAKE(coupling_missing, A, none, none, A);
MUELLE_COMMON_MISTAKE(springHessian, wrong_sign);
MUELLE_COMMON_MISTAKE(springHessian, doubled);

// --- elasticForce ---------------------------------------------------------------------------------------------------

namespace {

/// Each spring adds something to its two nodes; a spring without length none.
template <class Distribute>
VecX distributed(const VecX& x, const Springs& springs, const Distribute& distribute) {
  VecX F = VecX::Zero(x.size());
  for (const Spring& s : springs) {
    const Stretched at(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    const Vec3 Fa = at.L > 0 ? Vec3(-at.T() * at.n()) : Vec3(Vec3::Zero());
    distribute(F.segment<3>(3 * s.a), F.segment<3>(3 * s.b), Fa, at);
  }
  return F;
}

using Segment = Eigen::VectorBlock<VecX, 3>;

}  // namespace

#define FORCE_MISTAKE(id, ...)                                                                   \
  MUELLE_MISTAKE(elasticForce, id, [](const VecX& x, const Springs& springs) -> VecX {           \
    return distributed(x, springs,                                                               \
                       []([[maybe_unused]] Segment a, [[maybe_unused]] Segment b, const Vec3& F, \
                          [[maybe_unused]] const Stretched& at) { __VA_ARGS__; });               \
  })

FORCE_MISTAKE(one_end_only, a += F);
FORCE_MISTAKE(same_on_both_ends, a += F; b += F);
FORCE_MISTAKE(overwritten, a = F; b = -F);
namespace but_for_none {
FORCE_MISTAKE(
    overwritten, if (at.L > 0) {
      a = F;
      b = -F;
    });
}
FORCE_MISTAKE(not_normalised, a -= at.T() * at.r; b += at.T() * at.r; (void)F);
FORCE_MISTAKE(missing_rest, a -= at.k * at.r; b += at.k * at.r; (void)F);
FORCE_MISTAKE(
    rope, if (at.T() > 0) {
      a += F;
      b -= F;
    });
MUELLE_COMMON_MISTAKE(elasticForce, wrong_sign);
MUELLE_MISTAKE(elasticForce, unguarded, [](const VecX& x, const Springs& springs) -> VecX {
  return distributed(x, springs, [](Segment a, Segment b, const Vec3& F, const Stretched& at) {
    a += at.L > 0 ? F : Vec3(Vec3::Constant(undefined));
    b -= at.L > 0 ? F : Vec3(Vec3::Constant(undefined));
  });
});

// --- assembleHessian ------------------------------------------------------------------------------------------------

namespace {

/// What is done with entry (i, j) of a spring's Hessian at its place.
using Put = void (*)(double& place, double entry, int i, int j);

/// Where component c of node i has its row.
using Row = Eigen::Index (*)(int node, int c, Eigen::Index nodes);

Eigen::Index stackedRow(int node, int c, Eigen::Index) { return 3 * node + c; }
Eigen::Index rowByComponent(int node, int c, Eigen::Index nodes) { return c * nodes + node; }

SparseMatrix assembled(const VecX& x, const Springs& springs, Put put, Row row = stackedRow) {
  MatX K = MatX::Zero(x.size(), x.size());
  const Eigen::Index nodes = x.size() / 3;
  for (const Spring& s : springs) {
    const Mat6 one = oracle::springHessian(x.segment<3>(3 * s.a), x.segment<3>(3 * s.b), s.k, s.L0);
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        put(K(row(i < 3 ? s.a : s.b, i % 3, nodes), row(j < 3 ? s.a : s.b, j % 3, nodes)), one(i, j), i, j);
      }
    }
  }
  return K.sparseView(0, 0);
}

void add(double& place, double entry, int, int) { place += entry; }

Springs reversed(const Springs& springs) { return Springs(springs.rbegin(), springs.rend()); }

}  // namespace

#define ASSEMBLY_MISTAKE(id, ...) \
  MUELLE_MISTAKE(assembleHessian, id, [](const VecX& x, const Springs& springs) -> SparseMatrix { return __VA_ARGS__; })
#define ENTRY_MISTAKE_OF(inOrder, id, ...)                                                                    \
  ASSEMBLY_MISTAKE(id, assembled(x, inOrder, [](double& place, [[maybe_unused]] double entry, int i, int j) { \
                     [[maybe_unused]] const bool isDiagonal = (i < 3) == (j < 3);                             \
                     __VA_ARGS__;                                                                             \
                   }))
#define ENTRY_MISTAKE(id, ...) ENTRY_MISTAKE_OF(springs, id, __VA_ARGS__)
/// Where a later spring takes an earlier one's place, the order matters: that of the list, or backwards.
#define OVERWRITTEN_WHERE(...)                                                                     \
  ENTRY_MISTAKE(overwritten, place = (__VA_ARGS__) ? entry : place + entry);                       \
  namespace backwards {                                                                            \
  ENTRY_MISTAKE_OF(reversed(springs), overwritten, place = (__VA_ARGS__) ? entry : place + entry); \
  }

ENTRY_MISTAKE(coupling_missing, if (isDiagonal) place += entry);
ENTRY_MISTAKE(coupling_sign, place += isDiagonal ? entry : -entry);
ENTRY_MISTAKE(second_node_missing, if (i < 3) place += entry);
namespace of_all_blocks {
OVERWRITTEN_WHERE(true)
}
namespace of_both_nodes {
OVERWRITTEN_WHERE(isDiagonal)
}
namespace of_node_a {
OVERWRITTEN_WHERE(i < 3 && j < 3)
}
namespace of_node_b {
OVERWRITTEN_WHERE(i >= 3 && j >= 3)
}
namespace of_the_coupling {
ENTRY_MISTAKE(one_triangle, if (isDiagonal || i < 3) place += entry);
}
namespace of_the_other_coupling {
ENTRY_MISTAKE(one_triangle, if (isDiagonal || j < 3) place += entry);
}
namespace on_the_diagonal {
ENTRY_MISTAKE(second_node_missing, if (i < 3 || j < 3) place += entry);
}
ASSEMBLY_MISTAKE(rows_by_component, assembled(x, springs, add, rowByComponent));
ASSEMBLY_MISTAKE(one_triangle, SparseMatrix(oracle::assembleHessian(x, springs).triangularView<Eigen::Upper>()));
namespace lower {
ASSEMBLY_MISTAKE(one_triangle, SparseMatrix(oracle::assembleHessian(x, springs).triangularView<Eigen::Lower>()));
}

// --- backwardEulerStep ----------------------------------------------------------------------------------------------

namespace {

/// The step as it might have been written: (mass M + matrix K) dv = right, and what x goes on with.
struct Wrong {
  const State& now;
  VecX M;
  MatX K;
  VecX elastic, F;
  double h;

  Wrong(const State& state, const VecX& m, const Springs& springs, const VecX& other, double step)
      : now(state),
        M(state.x.size()),
        K(oracle::assembleHessian(state.x, springs)),
        elastic(oracle::elasticForce(state.x, springs)),
        F(other),
        h(step) {
    for (Eigen::Index i = 0; i < M.size(); ++i) M[i] = m[i / 3];
  }

  MatX diagonal() const { return M.asDiagonal(); }
  VecX all() const { return elastic + F; }
  VecX right() const { return h * (all() - h * (K * now.v)); }
  VecX solved(const MatX& system, const VecX& rhs) const { return muelle::engine::solvePartialPivoting(system, rhs); }
  State from(const MatX& system, const VecX& rhs) const {
    const VecX v = now.v + solved(system, rhs);
    return {now.x + h * v, v};
  }
  State rightOne() const { return from(diagonal() + h * h * K, right()); }
};

}  // namespace

#define STEP_MISTAKE(id, ...)                                                                                    \
  MUELLE_MISTAKE(backwardEulerStep, id,                                                                          \
                 [](const State& now, const VecX& m, const Springs& springs, const VecX& F, double h) -> State { \
                   const Wrong w(now, m, springs, F, h);                                                         \
                   return __VA_ARGS__;                                                                           \
                 })

STEP_MISTAKE(step_not_squared, w.from(w.diagonal() + h * w.K, w.right()));
STEP_MISTAKE(step_missing_in_matrix, w.from(w.diagonal() + w.K, w.right()));
STEP_MISTAKE(velocity_term_missing, w.from(w.diagonal() + h * h * w.K, h* w.all()));
STEP_MISTAKE(velocity_term_sign, w.from(w.diagonal() + h * h * w.K, h*(w.all() + h * (w.K * now.v))));
STEP_MISTAKE(velocity_term_without_step, w.from(w.diagonal() + h * h * w.K, h*(w.all() - w.K * now.v)));
STEP_MISTAKE(right_side_without_step, w.from(w.diagonal() + h * h * w.K, w.all() - h * (w.K * now.v)));
STEP_MISTAKE(matrix_sign, w.from(w.diagonal() - h * h * w.K, w.right()));
STEP_MISTAKE(hessian_sign, w.from(w.diagonal() - h * h * w.K, h*(w.all() + h * (w.K * now.v))));
STEP_MISTAKE(mass_missing, w.from(MatX::Identity(w.K.rows(), w.K.cols()) + h * h * w.K, w.right()));
STEP_MISTAKE(first_mass_for_all, w.from(MatX(m[0] * MatX::Identity(w.K.rows(), w.K.cols())) + h * h * w.K, w.right()));
STEP_MISTAKE(masses_in_turn, w.from(MatX(m.replicate(3, 1).asDiagonal()) + h * h * w.K, w.right()));
STEP_MISTAKE(explicit_step, w.from(w.diagonal(), h* w.all()));
STEP_MISTAKE(position_by_old_velocity, State{now.x + h * now.v, w.rightOne().v});
STEP_MISTAKE(position_by_change, State{now.x + h * (w.rightOne().v - now.v), w.rightOne().v});
STEP_MISTAKE(position_by_mean_velocity, State{now.x + h / 2 * (now.v + w.rightOne().v), w.rightOne().v});
STEP_MISTAKE(change_for_velocity, State{w.rightOne().x, w.rightOne().v - now.v});
namespace moved_by_it {
STEP_MISTAKE(change_for_velocity, State{now.x + h * (w.rightOne().v - now.v), w.rightOne().v - now.v});
}
STEP_MISTAKE(other_forces_forgotten, w.from(w.diagonal() + h * h * w.K, h*(w.elastic - h * (w.K * now.v))));
STEP_MISTAKE(springs_forgotten, w.from(w.diagonal() + h * h * w.K, h*(w.F - h * (w.K * now.v))));
STEP_MISTAKE(trapezoidal, w.from(w.diagonal() + h * h / 4 * w.K, h*(w.all() - h / 2 * (w.K * now.v))));
STEP_MISTAKE(moved_first, w.from(w.diagonal() + h * h * w.K, h*(oracle::elasticForce(now.x + h * now.v, springs) + F)));
namespace with_its_matrix {
STEP_MISTAKE(moved_first, w.from(w.diagonal() + h * h * MatX(oracle::assembleHessian(now.x + h * now.v, springs)),
                                 h*(oracle::elasticForce(now.x + h * now.v, springs) + F)));
}
STEP_MISTAKE(cholesky, muelle::engine::isPositiveDefinite(w.diagonal() + h * h * w.K)
                           ? w.rightOne()
                           : State{VecX::Constant(now.x.size(), undefined), VecX::Constant(now.x.size(), undefined)});
STEP_MISTAKE(velocity_counted_twice, w.from(w.diagonal() + h * h * w.K, w.M.cwiseProduct(now.v) + h * w.all()));

// --- guards ---------------------------------------------------------------------------------------------------------

namespace {

using HessianRegistration = muelle::grader::MistakeRegistration<decltype(::springHessian)>;
using ForceRegistration = muelle::grader::MistakeRegistration<decltype(::elasticForce)>;

constexpr double smallNumbers[] = {1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,  1e-9,  1e-10, 1e-11,
                                   1e-12, 1e-13, 1e-14, 1e-15, 1e-16, 1e-18, 1e-20, 1e-24, 1e-30, 1e-32};

struct Guards {
  std::vector<HessianRegistration> hessians;
  std::vector<ForceRegistration> forces;

  void addHessian(const char* id, double small, const Mat3& inUnitsOfK) {
    hessians.emplace_back("springHessian", id, &oracle::springHessian,
                          [small, inUnitsOfK](const Vec3& xa, const Vec3& xb, double k, double L0) {
                            if ((xa - xb).stableNorm() > small) return oracle::springHessian(xa, xb, k, L0);
                            return blocks(k * inUnitsOfK);
                          });
  }
  void addForce(double small) {
    forces.emplace_back(
        "elasticForce", "threshold", &oracle::elasticForce, [small](const VecX& x, const Springs& springs) {
          return distributed(x, springs, [small](Segment a, Segment b, const Vec3& F, const Stretched& at) {
            if (at.L < small) return;
            a += F;
            b -= F;
          });
        });
  }
};

Guards registerGuards() {
  Guards guards;
  guards.addHessian("zero_without_length", 0, Mat3::Zero());
  guards.addHessian("unguarded", 0, Mat3::Constant(undefined));
  for (const double small : smallNumbers) {
    guards.addHessian("threshold", small, Mat3::Identity());
    guards.addHessian("threshold", small, Mat3::Zero());
    guards.addForce(small);
  }
  return guards;
}

[[maybe_unused]] const Guards guards = registerGuards();

}  // namespace

// --- arguments in general position ----------------------------------------------------------------------------------

namespace {

using muelle::Random;
using muelle::threeDigits;

/// Four nodes tens of metres apart, more than 45 from the next.
VecX someNodes(Random& random) {
  VecX x(12);
  x << threeDigits(Vec3(random.vector3(4.3) + Vec3(-57, 13, 24))),
      threeDigits(Vec3(random.vector3(4.3) + Vec3(12, -7, 3))),
      threeDigits(Vec3(random.vector3(4.3) + Vec3(31, 43, -26))),
      threeDigits(Vec3(random.vector3(4.3) + Vec3(-17, 56, 61)));
  return x;
}

/// All of them stretched: a step in which one is compressed may be beyond a Cholesky factorisation.
Springs someSprings(Random& random) {
  Springs springs = {{0, 1, 0, 0}, {2, 1, 0, 0}, {2, 3, 0, 0}};
  for (Spring& s : springs) {
    s.k = random.rounded(20.0, 200.0);
    s.L0 = random.rounded(21.0, 43.0);
  }
  return springs;
}

VecX someNumbers(Random& random, Eigen::Index count, double low, double high) {
  VecX numbers(count);
  for (double& number : numbers) number = (random.integer(0, 1) == 0 ? 1 : -1) * random.rounded(low, high);
  return numbers;
}

}  // namespace

MUELLE_ARGUMENTS(springHessian, [](Random& random) {
  const Vec3 xa = threeDigits(Vec3(random.vector3(4.3) + Vec3(-57, 13, 24)));
  const Vec3 xb = threeDigits(Vec3(random.vector3(4.3) + Vec3(12, -7, 3)));
  const double k = random.rounded(20.0, 2000.0), L0 = random.rounded(31.0, 130.0);
  return std::tuple(xa, xb, k, L0);
});
MUELLE_ARGUMENTS(assembleHessian, [](Random& random) {
  const VecX x = someNodes(random);
  const Springs springs = someSprings(random);
  return std::tuple(x, springs);
});
MUELLE_ARGUMENTS(elasticForce, [](Random& random) {
  const VecX x = someNodes(random);
  const Springs springs = someSprings(random);
  return std::tuple(x, springs);
});
MUELLE_ARGUMENTS(backwardEulerStep, [](Random& random) {
  const State now{someNodes(random), someNumbers(random, 12, 11.0, 57.0)};
  VecX m(4);
  for (double& each : m) each = random.rounded(23.0, 79.0);
  const Springs springs = someSprings(random);
  const VecX F = someNumbers(random, 12, 200.0, 900.0);
  const double h = random.rounded(1.2, 1.9);
  return std::tuple(now, m, springs, F, h);
});
