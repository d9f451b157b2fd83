#include "sample_models.h"

#include <gtest/gtest.h>
#include <quadmath.h>
#include <cmath>
#include <Eigen/Geometry>

namespace muelle::engine::testing {
namespace {

__extension__ typedef __float128 Quad;

Model pair(int dimension, const Vec3& xb, double k, double L0) {
  Model model;
  model.dimension = dimension;
  model.nodes = {{.pinned = true}, {.x = xb}};
  model.springs = {{.a = 0, .b = 1, .k = k, .L0 = L0}};
  return model;
}

Eigen::MatrixXd stiffness(const DynamicalSystem& system, const State& s, Form form = Form::Exact) {
  SystemMatrix J;
  system.linearisation()->assemble(0.0, 0.0, 1.0, s.t, s.x, s.v, s.z, form, J);
  return J.sparse;
}

TEST(ZeroLength, HasItsEnergyNoForceAndAFiniteHessian) {
  for (int d = 1; d <= 3; ++d) {
    const auto system = build(pair(d, Vec3::Zero(), 100.0, 1.0));
    const State s = system->initialState();
    EXPECT_EQ(system->totalEnergy(s), 50.0);
    for (const double F : forceOf(*system, s)) EXPECT_EQ(F, 0.0);
    for (const Form form : {Form::Exact, Form::Symmetric, Form::Projected}) {
      EXPECT_EQ(stiffness(*system, s, form), 100.0 * Eigen::MatrixXd::Identity(d, d));
    }
  }
}

TEST(ZeroRestLength, IsExactlyIsotropic) {
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(0.1, 0.7, -0.3), Vec3(1e-200, 0, 3e-200)}) {
    const auto system = build(pair(3, x, 100.0, 0.0));
    const State s = system->initialState();
    EXPECT_LE((stiffness(*system, s) - 100.0 * Eigen::MatrixXd::Identity(3, 3)).norm(), 1e-13);
    const std::vector<double> f = forceOf(*system, s);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(f[static_cast<std::size_t>(c)], -100.0 * x[c]);
    EXPECT_EQ(system->switching(), nullptr) << "nothing happens at zero length";
  }
}

TEST(OffAxisComponents, StayExactlyZero) {
  const auto system = build(pair(3, Vec3(1.2, 0, 0), 100.0, 0.5));
  const State s = system->initialState();
  EXPECT_EQ(forceOf(*system, s)[1], 0.0);
  EXPECT_EQ(forceOf(*system, s)[2], 0.0);
}

/// Force and stiffness of a spring in binary128, in the component along (0) and across (1) of d = (x, y, z).
void referenceSpring(const Vec3& d, double k, double L0, Vec3& F, Mat3& K) {
  Quad L = 0;
  for (int i = 0; i < 3; ++i) L += static_cast<Quad>(d[i]) * static_cast<Quad>(d[i]);
  L = sqrtq(L);
  const Quad c = (L - static_cast<Quad>(L0)) / L;
  for (int i = 0; i < 3; ++i) {
    F[i] = static_cast<double>(-static_cast<Quad>(k) * c * static_cast<Quad>(d[i]));
    for (int j = 0; j < 3; ++j) {
      const Quad nn = static_cast<Quad>(d[i]) * static_cast<Quad>(d[j]) / (L * L);
      K(i, j) = static_cast<double>(static_cast<Quad>(k) * ((i == j ? c : Quad(0)) + (1 - c) * nn));
    }
  }
}

TEST(NearDegeneracy, ForceAndHessianFollowBinary128) {
  // Relative to their natural scales: k L for the force (a rounding of L is one of k L), k max(1, L0 / L) for K.
  for (const double L : {1e-9, 1e-5, 1.0 - 1e-12, 1.0, 1.0 + 1e-15, 1e6}) {
    const Vec3 d = L * Vec3(2, -1, 2) / 3.0;
    const auto system = build(pair(3, d, 100.0, 1.0));
    const State s = system->initialState();
    Vec3 F;
    Mat3 K;
    referenceSpring(d, 100.0, 1.0, F, K);
    const std::vector<double> f = forceOf(*system, s);
    EXPECT_LE((Vec3(f[0], f[1], f[2]) - F).norm(), 4e-16 * 100.0 * std::max(1.0, L)) << "L = " << L;
    EXPECT_LE((stiffness(*system, s) - K).norm(), 2e-15 * K.norm()) << "L = " << L;
  }
}

TEST(NearFlat, BendingFollowsBinary128) {
  // a - b - c with a turn of epsilon at b, edges of length 1: the force on c is -k theta, across bc.
  for (const double epsilon : {1e-12, 1e-8, 1e-3, 0.029, 0.031}) {
    for (int d = 2; d <= 3; ++d) {
      Model model;
      model.dimension = d;
      model.nodes = {{.x = {-1, 0, 0}}, {.x = {0, 0, 0}}, {.x = {1, 0, epsilon}}};
      model.angles = {{0, 1, 2, 5.0, 0.0}};
      const auto system = build(model);
      const State s = system->initialState();
      const Quad slope = static_cast<Quad>(epsilon), L = sqrtq(1 + slope * slope), theta = atanq(slope);
      const double Fz = static_cast<double>(-5 * theta / L / L), Fx = static_cast<double>(5 * theta * slope / L / L);
      const std::vector<double> f = forceOf(*system, s);
      EXPECT_NEAR(f[static_cast<std::size_t>(system->lane(2, 2))], Fz, 1e-15 * epsilon * 5.0);
      EXPECT_NEAR(f[static_cast<std::size_t>(system->lane(2, 0))], Fx, 1e-15 * epsilon * 5.0);
      // d2E/dz2 of c: k (theta'^2 + theta theta''), theta = atan z.
      const Quad bend = 5 * (1 / (L * L * L * L) - theta * 2 * slope / (L * L * L * L));
      const int z = system->unknown(2, 2);
      EXPECT_NEAR(stiffness(*system, s)(z, z), static_cast<double>(bend), 1e-13 * 5.0) << epsilon << " in " << d << "D";
    }
  }
}

TEST(NearFlat, DihedralFollowsBinary128) {
  for (const double epsilon : {0.0, 1e-12, 1e-6, 0.3}) {
    Model model;
    model.nodes = {{.x = {0, 0, 0}}, {.x = {0, 1, 0}}, {.x = {1, 0.5, 0}}, {.x = {-1, 0.5, epsilon}}};
    model.dihedrals = {{0, 1, 2, 3, 5.0, 0.0}};
    const auto system = build(model);
    const State s = system->initialState();
    const Quad z = static_cast<Quad>(epsilon), theta = atanq(z), r2 = 1 + z * z;
    EXPECT_NEAR(system->totalEnergy(s), static_cast<double>(Quad(2.5) * theta * theta), 1e-15 * epsilon * epsilon);
    EXPECT_NEAR(forceOf(*system, s)[static_cast<std::size_t>(system->lane(3, 2))], static_cast<double>(-5 * theta / r2),
                1e-15 * epsilon * 5.0);
    const int i = system->unknown(3, 2);
    EXPECT_NEAR(stiffness(*system, s)(i, i), static_cast<double>(5 * (1 - 2 * z * theta) / (r2 * r2)), 1e-14);
  }
}

TEST(SignedArea, DrivesAnInvertedTriangleBack) {
  // H15: apex below its base; A = 0.75 y, so the force on the apex is -ka (A - A0) 0.75 = 112.5 upwards.
  Model model;
  model.dimension = 2;
  model.plane = {0, 1};
  model.nodes = {{.x = {-0.75, 0, 0}, .pinned = true}, {.x = {0.75, 0, 0}, .pinned = true}, {.x = {0, -1, 0}}};
  model.areas = {{0, 1, 2, 100.0, 0.75}};
  const auto system = build(model);
  EXPECT_NEAR(forceOf(*system, system->initialState())[1], 112.5, 1e-12);
}

TEST(Buckling, TheHessianHasItsGeometricPart) {
  // H14: eigenvalues 200 along and -50 across; projected, none is negative.
  Model model;
  model.nodes = {{.x = {-0.8, 0, 0}, .pinned = true}, {.x = {0.8, 0, 0}, .pinned = true}, {}};
  model.springs = {{.a = 0, .b = 2, .k = 100.0, .L0 = 1.0}, {.a = 1, .b = 2, .k = 100.0, .L0 = 1.0}};
  const auto system = build(model);
  const State s = system->initialState();
  const Eigen::MatrixXd K = stiffness(*system, s), projected = stiffness(*system, s, Form::Projected);
  EXPECT_LE((K.diagonal() - Vec3(200, -50, -50)).norm(), 1e-12);
  EXPECT_LE((projected.diagonal() - Vec3(200, 0, 0)).norm(), 1e-12);
}

TEST(Crossing, TheForceIsSmoothThroughZeroLengthUntilTheEvent) {
  for (int d = 1; d <= 3; ++d) {
    Model model = pair(d, Vec3(0.1, 0, 0), 100.0, 0.5);
    model.nodes[1].v = {-5, 0, 0};
    model.springsCross = true;
    const auto system = build(model);
    ASSERT_NE(system->switching(), nullptr);
    const Switching& switching = *system->switching();
    State s = system->initialState();
    std::vector<double> guards(1);
    switching.commit(s, true);
    const auto guard = [&] {
      switching.guards(s.t, s.x, s.v, s.z, guards);
      return guards[0];
    };
    EXPECT_GT(guard(), 0.0);
    s.x[0] = -0.1;
    EXPECT_NEAR(forceOf(*system, s)[0], 100.0 * (0.1 + 0.5), 1e-12) << "goes on pushing as before";
    EXPECT_LT(guard(), 0.0);
    s.x[0] = 1e-14;  // located, but for rounding
    switching.cross(0, s);
    EXPECT_NEAR(forceOf(*system, s)[0], -100.0 * 0.5, 1e-9) << "and the other way after the event";
    EXPECT_FALSE(switching.commit(s, true)) << "which a commit leaves alone";
    s.x[0] = -0.1;
    EXPECT_NEAR(forceOf(*system, s)[0], 100.0 * (0.1 - 0.5), 1e-12);
    EXPECT_GT(guard(), 0.0) << "on its own side from then on";
    EXPECT_NEAR(system->potential()->energy(0.0, s.x, s.z), 50.0 * 0.4 * 0.4, 1e-12);
  }
}

TEST(Unilateral, PushesOnlyWhenShorterThanItsRestLength) {
  Model model = pair(1, Vec3(0.9, 0, 0), 1e4, 1.0);
  model.springs[0].unilateral = true;
  const auto system = build(model);
  State s = system->initialState();
  EXPECT_NEAR(forceOf(*system, s)[0], 1e3, 1e-10);
  s.x[0] = 1.1;
  EXPECT_EQ(forceOf(*system, s)[0], 0.0);
  EXPECT_EQ(system->potential()->energy(0.0, s.x, s.z), 0.0);
  // One-sided derivatives at the kink: live, k on the near side and nothing beyond.
  s.x[0] = 1.0 - 1e-9;
  EXPECT_NEAR(stiffness(*system, s)(0, 0), 1e4, 1e-8);
  s.x[0] = 1.0 + 1e-9;
  EXPECT_EQ(stiffness(*system, s)(0, 0), 0.0);
  // Frozen closed it pulls a little beyond, and the event opens it.
  s.x[0] = 0.9;
  system->switching()->commit(s, true);
  s.x[0] = 1.0 + 1e-3;
  EXPECT_NEAR(forceOf(*system, s)[0], -10.0, 1e-10);
  s.v[0] = 1.0;
  system->switching()->cross(0, s);
  EXPECT_EQ(forceOf(*system, s)[0], 0.0);
}

TEST(Damping, TheThreeFormsOfTheLectureAgreeInOneDimension) {
  const auto force = [](double drag, double relative, double projected) {
    Model model = pair(1, Vec3(0.3, 0, 0), 100.0, 0.0);
    model.nodes[1].v = {0.7, 0, 0};
    model.nodes[1].drag = drag;
    model.springs[0].dRelative = relative;
    model.springs[0].dProjected = projected;
    const auto system = build(model);
    return forceOf(*system, system->initialState())[0];
  };
  EXPECT_DOUBLE_EQ(force(2, 0, 0), -30.0 - 1.4);
  EXPECT_DOUBLE_EQ(force(0, 2, 0), -30.0 - 1.4);
  EXPECT_DOUBLE_EQ(force(0, 0, 2), -30.0 - 1.4);
}

}  // namespace
}  // namespace muelle::engine::testing
