#include "energy_gradient.h"

#include "course/testing/expect.h"
#include "course/testing/random.h"
#include "harness/function_system.h"
#include "harness/march.h"
#include "harness/symplectic_euler.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

using muelle::FunctionSystem;
using muelle::In;
using muelle::Mat3;
using muelle::Out;
using muelle::Random;
using muelle::roundOff;
using muelle::testRandom;
using muelle::Trajectory;

namespace {

/// One spring somewhere in space.
struct Case {
  Vec6 x;     ///< (xa, xb) [m]
  double k;   ///< [N/m]
  double L0;  ///< [m]
  double L;   ///< |xa - xb| [m]

  double forceScale() const { return k * (L + L0); }
  double energyScale() const { return k * (L * L + L0 * L0); }
};

Vec3 nodeA(const Vec6& x) { return x.head<3>(); }
Vec3 nodeB(const Vec6& x) { return x.tail<3>(); }

Vec6 stacked(const Vec3& xa, const Vec3& xb) {
  Vec6 x;
  x << xa, xb;
  return x;
}

/// A rest length that differs from L by a tenth at least: a stretched or a compressed spring, never one at rest.
double restLengthFor(Random& random, double L) {
  const double ratio = random.number(1.1, 2.5);
  return random.integer(0, 1) == 0 ? L * ratio : L / ratio;
}

Case anySpring(Random& random) {
  Case spring;
  const Vec3 xb = random.vector3(2.0);
  const Vec3 xa = xb + random.positive(0.3, 4.0) * random.direction();
  spring.x = stacked(xa, xb);
  spring.k = random.positive(5.0, 2000.0);
  spring.L = (xa - xb).norm();
  spring.L0 = restLengthFor(random, spring.L);
  return spring;
}

Case coincidentSpring(Random& random) {
  const Vec3 point = random.vector3(2.0);
  return {stacked(point, point), random.positive(5.0, 2000.0), random.number(0.3, 3.0), 0.0};
}

/// A spring whose nodes are as good as at one point, and are not: one of them is the origin, so that the other keeps
/// all its digits.
Case tinySpring(Random& random) {
  Case spring;
  const Vec3 point = random.positive(1e-20, 1e-16) * random.direction();
  spring.x = random.integer(0, 1) == 0 ? stacked(point, Vec3::Zero()) : stacked(Vec3::Zero(), point);
  spring.k = random.positive(5.0, 2000.0);
  spring.L = point.norm();
  spring.L0 = random.number(0.3, 3.0);
  return spring;
}

Vec6 moved(const Vec6& x, const Mat3& rotation, const Vec3& shift) {
  return stacked(rotation * nodeA(x) + shift, rotation * nodeB(x) + shift);
}

/// Central differences of the submission's energy in all six components.
Vec6 slopes(const Case& spring, double h) {
  Vec6 slope;
  for (int i = 0; i < 6; ++i) {
    Vec6 forward = spring.x;
    Vec6 backward = spring.x;
    forward[i] += h;
    backward[i] -= h;
    slope[i] = (submission::springEnergy(forward, spring.k, spring.L0) -
                submission::springEnergy(backward, spring.k, spring.L0)) /
               (forward[i] - backward[i]);
  }
  return slope;
}

}  // namespace

// --- EnergyInOneDimension -------------------------------------------------------------------------------------------

namespace {

struct Case1d {
  Vec2 x;
  double k;
  double L0;

  double scale() const { return k * ((x[0] - x[1]) * (x[0] - x[1]) + L0 * L0); }
};

/// Node a on the right for an even `number`, on the left for an odd one.
Case1d anySpring1d(Random& random, int number) {
  const double xb = random.number(-3.0, 3.0);
  const double L = random.number(0.3, 3.0);
  return {{number % 2 == 0 ? xb + L : xb - L, xb}, random.positive(5.0, 2000.0), restLengthFor(random, L)};
}

}  // namespace

TEST(EnergyInOneDimension, IsHalfTheStiffnessTimesTheSquaredStretch) {
  MUELLE_PROPERTY("in 1D the energy is that of the stretch L - L0 with L = |xa - xb|, whichever node is on the left");
  Random random = testRandom();
  for (int i = 0; i < 10; ++i) {
    const auto s = anySpring1d(random, i);
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(s.x, s.k, s.L0), oracle::springEnergy1d(s.x, s.k, s.L0),
                       roundOff(s.scale()));
  }
}

TEST(EnergyInOneDimension, DependsOnTheDistanceAlone) {
  MUELLE_PROPERTY("in 1D the energy stays the same when the nodes swap places or both move by the same amount");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const auto s = anySpring1d(random, i);
    const double shift = random.number(-5.0, 5.0);
    const double E = oracle::springEnergy1d(s.x, s.k, s.L0);
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(s.x[1], s.x[0]), s.k, s.L0), E, roundOff(s.scale()));
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(s.x[0] + shift, s.x[1] + shift), s.k, s.L0), E,
                       roundOff(s.scale()));
  }
}

TEST(EnergyInOneDimension, IsLeastAtTheRestLength) {
  MUELLE_PROPERTY("in 1D the energy is zero at L = L0 and grows alike for a stretch and a compression of one size");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    const double k = random.positive(5.0, 2000.0);
    const double L0 = 2.0;  // and 1.5, 2.5: exact in binary, so that the stretch is exactly zero at rest
    const double E = oracle::springEnergy1d(Vec2(L0 + 0.5, 0), k, L0);
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(L0, 0), k, L0), 0.0, roundOff(E));
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(0, L0 + 0.5), k, L0), E, roundOff(E));
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(0, L0 - 0.5), k, L0), E, roundOff(E));
  }
}

// --- EnergyInSpace --------------------------------------------------------------------------------------------------

TEST(EnergyInSpace, IsHalfTheStiffnessTimesTheSquaredStretch) {
  MUELLE_PROPERTY("in 3D the energy is that of the stretch L - L0 with L = |xa - xb|");
  Random random = testRandom();
  for (int i = 0; i < 10; ++i) {
    const Case s = anySpring(random);
    EXPECT_NUMBER_NEAR(submission::springEnergy(s.x, s.k, s.L0), oracle::springEnergy(s.x, s.k, s.L0),
                       roundOff(s.energyScale()));
  }
}

TEST(EnergyInSpace, DoesNotChangeWhenTheSpringIsMovedOrTurned) {
  MUELLE_PROPERTY("the energy stays the same when the spring is moved, turned, or its nodes are exchanged");
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Case s = anySpring(random);
    const double E = oracle::springEnergy(s.x, s.k, s.L0);
    const Vec6 elsewhere = moved(s.x, random.rotation(), random.vector3(3.0));
    EXPECT_NUMBER_NEAR(submission::springEnergy(elsewhere, s.k, s.L0), E, roundOff(s.energyScale()));
    const Vec6 exchanged = stacked(nodeB(s.x), nodeA(s.x));
    EXPECT_NUMBER_NEAR(submission::springEnergy(exchanged, s.k, s.L0), E, roundOff(s.energyScale()));
  }
}

TEST(EnergyInSpace, IsLeastAtTheRestLength) {
  MUELLE_PROPERTY("the energy is zero at L = L0 and grows alike for a stretch and a compression of one size");
  Random random = testRandom();
  for (int axis = 0; axis < 3; ++axis) {
    const double k = random.positive(5.0, 2000.0);
    const double L0 = 2.0;  // and 1.5, 2.5: exact in binary, so that the stretch is exactly zero at rest
    const Vec3 along = Vec3::Unit(axis);
    const Vec3 origin = Vec3::Zero();
    const double E = oracle::springEnergy(stacked(2.5 * along, origin), k, L0);
    EXPECT_NUMBER_NEAR(submission::springEnergy(stacked(2.0 * along, origin), k, L0), 0.0, roundOff(E));
    EXPECT_NUMBER_NEAR(submission::springEnergy(stacked(origin, 2.5 * along), k, L0), E, roundOff(E));
    EXPECT_NUMBER_NEAR(submission::springEnergy(stacked(origin, 1.5 * along), k, L0), E, roundOff(E));
  }
}

// --- LengthGradient -------------------------------------------------------------------------------------------------

TEST(LengthGradient, IsTheUnitVectorFromBToA) {
  MUELLE_PROPERTY("the gradient of L with respect to xa is the unit vector that points from b to a");
  Random random = testRandom();
  for (int i = 0; i < 10; ++i) {
    const Case s = anySpring(random);
    EXPECT_VECTOR_NEAR(submission::lengthGradient(nodeA(s.x), nodeB(s.x)),
                       oracle::lengthGradient(nodeA(s.x), nodeB(s.x)), roundOff(1));
  }
}

TEST(LengthGradient, IsTheSlopeOfTheLength) {
  MUELLE_PROPERTY("each component is the slope of |xa - xb| when that component of xa moves");
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Case s = anySpring(random);
    const Vec3 xa = nodeA(s.x);
    const Vec3 xb = nodeB(s.x);
    const double h = 1e-5 * s.L;
    // Central difference: L''' = 3 u (1 - u^2) / L^2 with u the component of the direction, 1.16 / L^2 at most, so an
    // error of h^2 / (5 L^2); and the rounding of two lengths and of positions of a few metres, eps * 10 m / h.
    const double tolerance = h * h / (5 * s.L * s.L) + 2.3e-16 * (s.L + 10) / h;
    Vec3 slope;
    for (int c = 0; c < 3; ++c) {
      const Vec3 step = h * Vec3::Unit(c);
      slope[c] = ((xa + step - xb).norm() - (xa - step - xb).norm()) / (2 * h);
    }
    EXPECT_VECTOR_NEAR(submission::lengthGradient(xa, xb), slope, tolerance);
  }
}

TEST(LengthGradient, IsOppositeForTheOtherNode) {
  MUELLE_PROPERTY("exchanging the nodes turns the gradient of the length round");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Case s = anySpring(random);
    const Vec3 gradient = submission::lengthGradient(nodeA(s.x), nodeB(s.x));
    EXPECT_VECTOR_NEAR(gradient, oracle::lengthGradient(nodeA(s.x), nodeB(s.x)), roundOff(1));
    EXPECT_VECTOR_NEAR(submission::lengthGradient(nodeB(s.x), nodeA(s.x)), -gradient, roundOff(1));
  }
}

// --- EnergyGradient: partial, so every test stands on generic values of its own ------------------------------------

TEST(EnergyGradient, HasTheDerivativeWithRespectToA) {
  MUELLE_PROPERTY("components 0 to 2 of the energy gradient are the derivatives with respect to xa");
  Random random = testRandom();
  for (int i = 0; i < 8; ++i) {
    const Case s = anySpring(random);
    EXPECT_VECTOR_NEAR(Vec3(submission::energyGradient(s.x, s.k, s.L0).head<3>()),
                       Vec3(oracle::energyGradient(s.x, s.k, s.L0).head<3>()), roundOff(s.forceScale()));
  }
}

TEST(EnergyGradient, HasTheDerivativeWithRespectToB) {
  MUELLE_PROPERTY("components 3 to 5 of the energy gradient are the derivatives with respect to xb");
  Random random = testRandom();
  for (int i = 0; i < 8; ++i) {
    const Case s = anySpring(random);
    EXPECT_VECTOR_NEAR(Vec3(submission::energyGradient(s.x, s.k, s.L0).tail<3>()),
                       Vec3(oracle::energyGradient(s.x, s.k, s.L0).tail<3>()), roundOff(s.forceScale()));
  }
}

TEST(EnergyGradient, TurnsWithTheSpring) {
  MUELLE_PROPERTY("moving the spring leaves its gradient alone, turning the spring turns the gradient");
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Case s = anySpring(random);
    const Mat3 rotation = random.rotation();
    const Vec6 turned = submission::energyGradient(moved(s.x, rotation, random.vector3(3.0)), s.k, s.L0);
    const Vec6 expected = moved(oracle::energyGradient(s.x, s.k, s.L0), rotation, Vec3::Zero());
    EXPECT_VECTOR_NEAR(turned, expected, roundOff(s.forceScale()));
  }
}

// --- FiniteDifferences ----------------------------------------------------------------------------------------------

TEST(FiniteDifferences, OfTheEnergyAreTheGradient) {
  MUELLE_PROPERTY("each component of energyGradient is the slope of springEnergy when that component of x moves");
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Case s = anySpring(random);
    const double h = 1e-4 * s.L;
    // E''' = -k L0 L''' with |L'''| <= 1.16 / L^2; the energies carry a few roundings, some 1e-15 of k (L^2 + L0^2),
    // and those of the positions (a few metres), which enter through the force.
    const double truncation = h * h * s.k * s.L0 / (5 * s.L * s.L);
    const double rounding = 1e-15 * (s.energyScale() + s.forceScale() * 10) / h;
    const Vec6 gradient = submission::energyGradient(s.x, s.k, s.L0);
    EXPECT_VECTOR_NEAR(gradient, oracle::energyGradient(s.x, s.k, s.L0), roundOff(s.forceScale()));
    EXPECT_VECTOR_NEAR(slopes(s, h), gradient, truncation + rounding);
  }
}

TEST(FiniteDifferences, ConvergeToTheGradientWithOrderTwo) {
  MUELLE_PROPERTY(
      "halving the step of the central difference of springEnergy divides its distance to energyGradient by four");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    Case s = anySpring(random);
    // A direction along no axis: the third derivative along an axis vanishes for a spring that lies along it.
    s.x.head<3>() = nodeB(s.x) + s.L * Vec3(0.6, 0.48, -0.64);
    const Vec6 gradient = submission::energyGradient(s.x, s.k, s.L0);
    EXPECT_VECTOR_NEAR(gradient, oracle::energyGradient(s.x, s.k, s.L0), roundOff(s.forceScale()));
    const double h = 0.02 * s.L;
    const double coarse = (slopes(s, h) - gradient).norm();
    const double fine = (slopes(s, h / 2) - gradient).norm();
    // The next term of the error is of relative size 2 (h / L)^2 = 8e-4, which moves the order by 1e-3 at most; the
    // rounding, 1e-15 / 0.02 of the force, is far below.
    EXPECT_NUMBER_NEAR(std::log2(coarse / fine), 2.0, 0.01);
  }
}

// --- Forces ---------------------------------------------------------------------------------------------------------

TEST(Forces, LeadDownhillInEnergy) {
  MUELLE_PROPERTY("the forces are minus the gradient of the energy, block by block");
  Random random = testRandom();
  for (int i = 0; i < 8; ++i) {
    const Case s = anySpring(random);
    EXPECT_VECTOR_NEAR(submission::springForces(s.x, s.k, s.L0), oracle::springForces(s.x, s.k, s.L0),
                       roundOff(s.forceScale()));
  }
}

TEST(Forces, PullTogetherWhenStretchedAndPushApartWhenCompressed) {
  MUELLE_PROPERTY(
      "a stretched spring pulls its nodes together, a compressed one pushes them apart, one at rest does nothing");
  Random random = testRandom();
  for (int axis = 0; axis < 3; ++axis) {
    const double k = random.positive(5.0, 2000.0);
    const double L0 = 2.0;
    const Vec3 along = Vec3::Unit(axis);
    const auto forceOnA = [&](double L) -> Vec3 {
      return submission::springForces(stacked(L * along, Vec3::Zero()), k, L0).head<3>();
    };
    EXPECT_VECTOR_NEAR(forceOnA(2.5), Vec3(-0.5 * k * along), roundOff(k * L0));
    EXPECT_VECTOR_NEAR(forceOnA(1.5), Vec3(0.5 * k * along), roundOff(k * L0));
    EXPECT_VECTOR_NEAR(forceOnA(2.0), Vec3(Vec3::Zero()), roundOff(k * L0));
  }
}

TEST(Forces, ObeyNewtonsThirdLaw) {
  MUELLE_PROPERTY("the forces on a and b are opposite and along the spring: no net force, no net torque");
  Random random = testRandom();
  for (int i = 0; i < 5; ++i) {
    const Case s = anySpring(random);
    const Vec6 forces = submission::springForces(s.x, s.k, s.L0);
    EXPECT_VECTOR_NEAR(forces, oracle::springForces(s.x, s.k, s.L0), roundOff(s.forceScale()));
    const Vec3 onA = forces.head<3>();
    const Vec3 onB = forces.tail<3>();
    EXPECT_VECTOR_NEAR(Vec3(onA + onB), Vec3(Vec3::Zero()), roundOff(s.forceScale()));
    EXPECT_VECTOR_NEAR(Vec3(nodeA(s.x).cross(onA) + nodeB(s.x).cross(onB)), Vec3(Vec3::Zero()),
                       roundOff(s.forceScale() * (2 + s.L)));
  }
}

// --- CoincidentNodes: partial ---------------------------------------------------------------------------------------

TEST(CoincidentNodes, KeepTheEnergyOfFullCompression) {
  MUELLE_PROPERTY("where both nodes coincide the energy is that of a spring compressed by all of its rest length");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Case s = coincidentSpring(random);
    const double E = 0.5 * s.k * s.L0 * s.L0;
    EXPECT_NUMBER_NEAR(submission::springEnergy(s.x, s.k, s.L0), E, roundOff(E));
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(Vec2(s.x[0], s.x[3]), s.k, s.L0), E, roundOff(E));
  }
  for (int i = 0; i < 3; ++i) {  // and the rest of the energy is as it should be
    const Case s = anySpring(random);
    EXPECT_NUMBER_NEAR(submission::springEnergy(s.x, s.k, s.L0), oracle::springEnergy(s.x, s.k, s.L0),
                       roundOff(s.energyScale()));
    const auto s1d = anySpring1d(random, i);
    EXPECT_NUMBER_NEAR(submission::springEnergy1d(s1d.x, s1d.k, s1d.L0), oracle::springEnergy1d(s1d.x, s1d.k, s1d.L0),
                       roundOff(s1d.scale()));
  }
}

namespace {

void expectGradientsAndForces(const Case& s) {
  EXPECT_VECTOR_NEAR(submission::lengthGradient(nodeA(s.x), nodeB(s.x)), oracle::lengthGradient(nodeA(s.x), nodeB(s.x)),
                     roundOff(1));
  EXPECT_VECTOR_NEAR(submission::energyGradient(s.x, s.k, s.L0), oracle::energyGradient(s.x, s.k, s.L0),
                     roundOff(s.forceScale()));
  EXPECT_VECTOR_NEAR(submission::springForces(s.x, s.k, s.L0), oracle::springForces(s.x, s.k, s.L0),
                     roundOff(s.forceScale()));
}

}  // namespace

TEST(CoincidentNodes, HaveNoGradientAndNoForce) {
  MUELLE_PROPERTY("where both nodes coincide gradients and forces are zero, not NaN");
  Random random = testRandom();
  for (int i = 0; i < 3; ++i) {
    const Case s = coincidentSpring(random);
    EXPECT_VECTOR_NEAR(submission::lengthGradient(nodeA(s.x), nodeB(s.x)), Vec3(Vec3::Zero()), 0.0);
    EXPECT_VECTOR_NEAR(submission::energyGradient(s.x, s.k, s.L0), Vec6(Vec6::Zero()), 0.0);
    EXPECT_VECTOR_NEAR(submission::springForces(s.x, s.k, s.L0), Vec6(Vec6::Zero()), 0.0);
  }
  for (int i = 0; i < 3; ++i) expectGradientsAndForces(anySpring(random));  // zero everywhere is not the answer
}

// --- TinyLengths ----------------------------------------------------------------------------------------------------

TEST(TinyLengths, HaveADirection) {
  MUELLE_PROPERTY("a spring of any length above zero has a direction, and so a gradient and a force");
  Random random = testRandom();
  for (int i = 0; i < 6; ++i) expectGradientsAndForces(tinySpring(random));
  for (int i = 0; i < 3; ++i) expectGradientsAndForces(anySpring(random));
}

// --- StretchAndRelease ----------------------------------------------------------------------------------------------

namespace {

/// Work [J] of the submission's forces along a path of both nodes, by the trapezoidal rule; every force is also
/// compared with the expected one.
double work(const Case& s, const std::vector<Vec6>& path) {
  double total = 0.0;
  Vec6 before = Vec6::Zero();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Vec6 forces = submission::springForces(path[i], s.k, s.L0);
    EXPECT_VECTOR_NEAR(forces, oracle::springForces(path[i], s.k, s.L0), roundOff(s.forceScale()));
    if (i > 0) total += 0.5 * (before + forces).dot(path[i] - path[i - 1]);
    before = forces;
  }
  return total;
}

}  // namespace

TEST(StretchAndRelease, StoresTheWorkAsEnergy) {
  MUELLE_PROPERTY("the work done against springForces to stretch a spring is what springEnergy gains");
  Random random = testRandom();
  for (int i = 0; i < 4; ++i) {
    const Case s = anySpring(random);
    const Vec3 along = oracle::lengthGradient(nodeA(s.x), nodeB(s.x));
    std::vector<Vec6> path;
    for (int step = 0; step <= 4; ++step) path.push_back(s.x + 0.25 * step * s.L * stacked(0.7 * along, -0.4 * along));
    // Along the spring the force is linear in the length, and the trapezoidal rule is exact.
    const double gained = oracle::springEnergy(path.back(), s.k, s.L0) - oracle::springEnergy(s.x, s.k, s.L0);
    const double stored = submission::springEnergy(path.back(), s.k, s.L0) - submission::springEnergy(s.x, s.k, s.L0);
    const double tolerance = roundOff(4 * s.energyScale());
    EXPECT_NUMBER_NEAR(stored, gained, tolerance);
    EXPECT_NUMBER_NEAR(-work(s, path), stored, tolerance);
  }
}

TEST(StretchAndRelease, GivesTheEnergyBackOverACycle) {
  MUELLE_PROPERTY("over any closed path of the nodes the work of springForces is zero");
  Random random = testRandom();
  for (int i = 0; i < 2; ++i) {
    const Case s = anySpring(random);
    const Vec3 u = random.direction();
    const Vec3 w = random.direction();
    const auto on = [&](double angle) -> Vec6 {
      return s.x + 0.2 * s.L * stacked(std::cos(angle) * u + std::sin(angle) * w, std::sin(angle) * u);
    };
    // The integrand is smooth and periodic: the nodes come no closer than L / 2, since the loop moves them by less than
    // 0.2 (1 + sqrt(2)) L, and the sum over equal steps with the exact tangent converges geometrically. 96 points leave
    // round-off.
    constexpr int n = 96;
    double total = 0.0;
    for (int step = 0; step < n; ++step) {
      const double angle = 2 * M_PI * step / n;
      const Vec6 tangent = (on(angle + M_PI / 2) - s.x);  // the derivative of cos and sin
      const Vec6 forces = submission::springForces(on(angle), s.k, s.L0);
      EXPECT_VECTOR_NEAR(forces, oracle::springForces(on(angle), s.k, s.L0), roundOff(2 * s.forceScale()));
      total += forces.dot(tangent) * 2 * M_PI / n;
    }
    EXPECT_NUMBER_NEAR(total, 0.0, roundOff(2 * s.energyScale()));
  }
}

namespace {

using Forces = std::function<Vec6(const Vec6&)>;

/// Two free nodes of 0.5 and 0.8 kg joined by the spring, thrown so that they swing and turn.
Trajectory swing(const Vec6& start, const Forces& forces) {
  const FunctionSystem system({0.5, 0.5, 0.5, 0.8, 0.8, 0.8}, [&](double, In x, In, Out f) {
    const Vec6 F = forces(Eigen::Map<const Vec6>(x.data()));
    std::copy(F.begin(), F.end(), f.begin());
  });
  muelle::State state;
  state.x.assign(start.begin(), start.end());
  state.v = {0.3, 0.8, -0.2, -0.1, -0.4, 0.5};
  muelle::MarchOptions options;
  options.h = 2e-3;
  options.duration = 1.2;  // about three swings
  return muelle::march(system, state, options);
}

Vec6 positions(const Trajectory& run, std::size_t i) { return Eigen::Map<const Vec6>(run.x[i].data()); }

}  // namespace

TEST(StretchAndRelease, SwingsLikeTheReference) {
  MUELLE_PROPERTY("a free pair of nodes on the spring moves, and stores and releases energy, as the reference does");
  Random random = testRandom();
  const double k = random.number(50.0, 90.0);
  const double L0 = 1.0;
  const Vec3 along = random.direction();
  const Vec6 start = stacked(0.7 * along, -0.6 * along);
  const Trajectory run = swing(start, [&](const Vec6& x) { return submission::springForces(x, k, L0); });
  ASSERT_FALSE(run.stop.stopped) << run.stop.message;
  const auto expectedForces = [&](const Vec6& x) { return oracle::springForces(x, k, L0); };
  const Trajectory reference = swing(start, expectedForces);
  const Trajectory aside = swing(start + 1e-9 * stacked(random.direction(), random.direction()), expectedForces);
  // Round-off in a force is far below 1e-9 of it; what 1e-9 m at the start grow to bounds what it may grow to.
  double drift = 1e-9;
  for (std::size_t i = 0; i < reference.t.size(); ++i) {
    drift = std::max(drift, (positions(aside, i) - positions(reference, i)).norm());
  }
  for (std::size_t i = 0; i < reference.t.size(); i += 20) {
    ASSERT_VECTOR_NEAR(positions(run, i), positions(reference, i), drift);
    const double E = oracle::springEnergy(positions(reference, i), k, L0);
    // The slope of the energy is at most the force, k |L - L0| < 2 k L0 here.
    ASSERT_NUMBER_NEAR(submission::springEnergy(positions(run, i), k, L0), E, 4 * k * L0 * drift);
  }
}
