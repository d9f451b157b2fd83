#include "engine/solve/dense.h"
#include "sample_models.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <set>
#include <string>

namespace muelle::engine::testing {
namespace {

/// One kind of force in one dimension, at a random state.
struct Kind {
  const char* name;
  int dimension;
  void (*add)(Model& model, Random& random);
};

void addGravity(Model& model, Random&) { model.gravity = -9.81 * up(model.dimension); }

void addDrag(Model& model, Random& random) {
  for (ModelNode& node : model.nodes) node.drag = 1.0 + random();
}

void addSpringsWith(Model& model, Random& random, double relative, double projected, bool unilateral) {
  for (int a = 0; a < 6; ++a) {
    for (int b = a + 1; b < 6; ++b) {
      if ((a + b) % 3 == 0) continue;
      ModelSpring spring{a, b, 10.0 + 5.0 * random(), 1.0 + 0.5 * random(), relative, projected, unilateral};
      if (unilateral) spring.L0 = 2.0;  // some shorter, some longer
      model.springs.push_back(spring);
    }
  }
}

void addSprings(Model& model, Random& random) { addSpringsWith(model, random, 0.0, 0.0, false); }
void addRelativeDamping(Model& model, Random& random) { addSpringsWith(model, random, 0.7, 0.0, false); }
void addProjectedDamping(Model& model, Random& random) { addSpringsWith(model, random, 0.0, 0.9, false); }
void addUnilateral(Model& model, Random& random) { addSpringsWith(model, random, 0.4, 0.6, true); }
void addCrossing(Model& model, Random& random) {
  addSprings(model, random);
  model.springsCross = true;
}

void addAngles(Model& model, Random&) {
  model.angles = {{0, 1, 2, 3.0, 0.0}, {3, 0, 4, 2.0, 0.7}, {4, 5, 1, 1.5, 0.0}};
}
void addDihedrals(Model& model, Random&) { model.dihedrals = {{0, 1, 2, 3, 3.0, 0.0}, {4, 0, 5, 1, 2.0, 0.8}}; }
void addAreas(Model& model, Random&) {
  const Vec3 normal = Vec3(1, 2, -2) / 3.0;
  model.areas = {{0, 1, 2, 30.0, 0.4, normal}, {3, 5, 4, 20.0, -0.7, normal}};
}
void addVolumes(Model& model, Random&) { model.volumes = {{0, 1, 2, 3, 30.0, 0.4}, {4, 5, 1, 0, 20.0, -0.2}}; }

void addProperty(Model& model, Random& random) {
  ModelProperty property;
  for (const int node : {0, 1, 2, 4, 1}) {
    property.nodes.push_back(node);
    property.weights.push_back(random.vector());
  }
  property.k = 30.0;
  property.p0 = 0.4;
  model.properties = {property, property};
  model.properties[1].k = 5.0;
}

void addExternal(Model& model, Random&) {
  model.externalForces.push_back({{0, 2, 3}, [](double t, int) { return Vec3(1 + t, 2, 3); }, {}});
}

void addObstacle(Model& model, Obstacle::Kind kind, double d, double mu) {
  Obstacle obstacle;
  obstacle.kind = kind;
  obstacle.centre = 0.2 * up(model.dimension);
  if (model.dimension == 1) obstacle.centre[0] = 3.0;
  obstacle.normal = model.dimension == 3   ? Vec3(Vec3(2, 1, 2) / 3.0)
                    : model.dimension == 2 ? Vec3(Vec3(3, 0, 4) / 5.0)
                                           : Vec3(Vec3::UnitX());
  obstacle.radius = 1.4;
  obstacle.halfSize = {1.3, 1.2, 0.9};
  obstacle.material = {20.0, d, mu, 15.0, 0.8};
  obstacle.velocity = {0.2, 0.1, 0.3};
  model.obstacles.push_back(obstacle);
}

template <Obstacle::Kind kind>
void addElasticObstacle(Model& model, Random&) {
  addObstacle(model, kind, 0.0, 0.0);
}
template <Obstacle::Kind kind>
void addDampedObstacle(Model& model, Random&) {
  addObstacle(model, kind, 2.0, 0.0);
}
template <Obstacle::Kind kind>
void addFriction(Model& model, Random&) {
  addObstacle(model, kind, 1.0, 0.3);
}

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  using OK = Obstacle::Kind;
  const std::vector<std::pair<const char*, void (*)(Model&, Random&)>> everywhere = {
      {"gravity", addGravity},
      {"drag", addDrag},
      {"springs", addSprings},
      {"relative_damping", addRelativeDamping},
      {"projected_damping", addProjectedDamping},
      {"unilateral", addUnilateral},
      {"crossing", addCrossing},
      {"property", addProperty},
      {"external", addExternal},
      {"plane", addElasticObstacle<OK::Plane>},
      {"sphere", addElasticObstacle<OK::Sphere>},
      {"box", addElasticObstacle<OK::Box>},
      {"damped_plane", addDampedObstacle<OK::Plane>},
      {"damped_sphere", addDampedObstacle<OK::Sphere>},
      {"damped_box", addDampedObstacle<OK::Box>},
      {"friction_plane", addFriction<OK::Plane>},
      {"friction_sphere", addFriction<OK::Sphere>},
      {"friction_box", addFriction<OK::Box>},
  };
  for (int d = 1; d <= 3; ++d) {
    for (const auto& [name, add] : everywhere) all.push_back({name, d, add});
    if (d > 1) all.push_back({"angle", d, addAngles});
    if (d > 1) all.push_back({"area", d, addAreas});
    if (d > 2) all.push_back({"dihedral", d, addDihedrals});
    if (d > 2) all.push_back({"volume", d, addVolumes});
  }
  return all;
}

/// Every test goes through all kinds: a program a test is too dear for 60 kinds.
class Derivatives : public ::testing::Test {
 protected:
  static constexpr int states = 3;

  /// The system, and a state a little away from its last commit, so that friction anchors are stretched.
  State prepare(unsigned seed) {
    Random random(seed + 100);
    Model model = sixNodes(kind_.dimension, seed);
    kind_.add(model, random);
    system_ = build(model);
    State state = system_->initialState();
    if (system_->switching() != nullptr) system_->switching()->commit(state, seed % 2 == 0);
    for (int i = 0; i < n(); ++i) state.x[laneOf(*system_, i)] += 0.02 * random();
    return state;
  }
  int n() const { return system_->size(); }

  /// The unknowns of what a function writes to lanes.
  template <class Write>
  Eigen::VectorXd unknownsOf(Write&& write) const {
    std::vector<double> lanes(static_cast<std::size_t>(system_->storage()));
    write(lanes);
    Eigen::VectorXd unknowns(n());
    for (int i = 0; i < n(); ++i) unknowns[i] = lanes[laneOf(*system_, i)];
    return unknowns;
  }
  Eigen::VectorXd force(const State& s) const {
    return unknownsOf([&](Out f) { system_->force(s.t, s.x, s.v, s.z, f); });
  }
  Eigen::VectorXd conservative(const State& s) const {
    return unknownsOf([&](Out f) { system_->potential()->conservativeForce(s.t, s.x, s.z, f); });
  }
  Eigen::MatrixXd matrix(double cD, double cK, const State& s, Form form) const {
    SystemMatrix J;
    system_->linearisation()->assemble(0.0, cD, cK, s.t, s.x, s.v, s.z, form, J);
    Eigen::MatrixXd A = J.sparse;
    if (!J.lowRank.empty()) A += J.lowRank.U * J.lowRank.s.asDiagonal() * J.lowRank.U.transpose();
    if (J.symmetric) {
      EXPECT_LE((A - A.transpose()).norm(), 1e-13 * A.norm());
    }
    return A;
  }
  /// Minus the derivative of a force by central differences of two widths, extrapolated: an error of order width^4.
  template <class F>
  Eigen::MatrixXd differences(State s, std::vector<double> State::*which, F&& f) const {
    Eigen::MatrixXd A(n(), n());
    constexpr double h = 1e-4;
    for (int i = 0; i < n(); ++i) {
      double& q = (s.*which)[laneOf(*system_, i)];
      const double old = q;
      const auto slope = [&](double width) -> Eigen::VectorXd {
        q = old + width;
        const Eigen::VectorXd after = f(s);
        q = old - width;
        const Eigen::VectorXd before = f(s);
        q = old;
        return (after - before) / (2.0 * width);
      };
      A.col(i) = -(4.0 * slope(0.5 * h) - slope(h)) / 3.0;
    }
    return A;
  }

  bool is(const char* word) const { return std::string(kind_.name).find(word) != std::string::npos; }

  /// Calls check(state, seed) for states of every kind.
  template <class Check>
  void forAll(Check&& check) {
    for (const Kind& kind : kinds()) {
      kind_ = kind;
      for (unsigned seed = 0; seed < states; ++seed) {
        SCOPED_TRACE(std::string(kind.name) + " in " + std::to_string(kind.dimension) + "D, state " +
                     std::to_string(seed));
        check(prepare(seed), seed);
      }
    }
  }

  Kind kind_{};
  std::unique_ptr<ModelSystem> system_;
};

TEST_F(Derivatives, AreThoseOfEveryKindOfElement) {
  std::set<std::string> held;
  Random random(1);
  for (const Kind& kind : kinds()) {
    Model model = sixNodes(kind.dimension, 0);
    kind.add(model, random);
    forEachElementKind(model, [&]<class List>(const List& elements) {
      if (!elements.empty()) held.insert(ElementOf<List>::kind);
    });
  }
  const Model none;
  forEachElementKind(none, [&]<class List>(const List&) {
    EXPECT_TRUE(held.contains(ElementOf<List>::kind)) << ElementOf<List>::kind << " has no line in kinds()";
  });
}

// Rounding of a force of size F leaves F * 1e-16 / h = 1e-12 F in the difference, and the extrapolation an error of
// h^4 = 1e-16 times the fifth derivative; forces are at most some hundred times their derivatives here.
constexpr double tolerance = 3e-9;

TEST_F(Derivatives, ForceIsMinusTheGradientOfTheEnergy) {
  forAll([&](const State& s, unsigned) {
    const Eigen::MatrixXd slope = differences(s, &State::x, [&](const State& at) {
      return Eigen::VectorXd::Constant(1, system_->potential()->energy(at.t, at.x, at.z)).replicate(n(), 1).eval();
    });
    const Eigen::VectorXd f = conservative(s);
    EXPECT_LE((slope.row(0).transpose() - f).norm(), tolerance * std::max(1.0, f.norm()));
    if (system_->potential()->isComplete()) {
      EXPECT_LE((f - force(s)).norm(), 1e-13 * std::max(1.0, f.norm()));
    }
  });
}

TEST_F(Derivatives, ExactFormIsTheDerivativeOfTheForce) {
  forAll([&](const State& s, unsigned) {
    const auto total = [&](const State& at) { return force(at); };
    const Eigen::MatrixXd K = matrix(0.0, 1.0, s, Form::Exact), D = matrix(1.0, 0.0, s, Form::Exact);
    EXPECT_LE((K - differences(s, &State::x, total)).norm(), tolerance * std::max(1.0, K.norm()));
    EXPECT_LE((D - differences(s, &State::v, total)).norm(), tolerance * std::max(1.0, D.norm()));
    EXPECT_LE((matrix(2.0, 3.0, s, Form::Exact) - 3.0 * K - 2.0 * D).norm(), 1e-13 * (K.norm() + D.norm()));
  });
}

TEST_F(Derivatives, SymmetricFormIsTheHessianOfTheEnergy) {
  forAll([&](const State& s, unsigned seed) {
    const Eigen::MatrixXd K = matrix(0.0, 1.0, s, Form::Symmetric);
    EXPECT_LE((K - K.transpose()).norm(), 1e-13 * K.norm());
    if (is("friction")) return;                  // adds its own, which has no energy
    if (is("damped_") && seed % 2 == 1) return;  // live: contacts that let go
    const Eigen::MatrixXd H = differences(s, &State::x, [&](const State& at) { return conservative(at); });
    EXPECT_LE((K - H).norm(), tolerance * std::max(1.0, K.norm()));
  });
}

TEST_F(Derivatives, ProjectedFormIsPositiveSemidefinite) {
  forAll([&](const State& s, unsigned) {
    const Eigen::MatrixXd K = matrix(0.3, 1.0, s, Form::Projected);
    EXPECT_LE((K - K.transpose()).norm(), 1e-13 * K.norm());
    const Eigen::VectorXd eigenvalues = symmetricEigenvalues(K);
    EXPECT_GE(eigenvalues.minCoeff(), -1e-12 * K.norm());
  });
}

TEST_F(Derivatives, DiscreteGradientDoesTheWorkOfTheEnergy) {
  forAll([&](const State& a, unsigned seed) {
    Random random(seed);
    Eigen::VectorXd f;
    for (const double size : {0.3, 1e-3, 1e-7, 0.0}) {
      State b = a;
      for (int i = 0; i < n(); ++i) b.x[laneOf(*system_, i)] += size * random();
      const Potential& potential = *system_->potential();
      const Eigen::VectorXd back = unknownsOf([&](Out to) { potential.discreteGradientForce(0.0, b.x, a.x, a.z, to); });
      f = unknownsOf([&](Out to) { potential.discreteGradientForce(0.0, a.x, b.x, a.z, to); });
      double work = 0.0;
      for (int i = 0; i < n(); ++i) work += f[i] * (b.x[laneOf(*system_, i)] - a.x[laneOf(*system_, i)]);
      const double Ea = potential.energy(0.0, a.x, a.z), Eb = potential.energy(0.0, b.x, b.z);
      // Rounding of the energies, and of the work: some dozen terms each.
      EXPECT_NEAR(work, Ea - Eb, 1e-14 * (std::abs(Ea) + std::abs(Eb) + f.norm() + 1.0)) << "step of " << size;
      EXPECT_LE((f - back).norm(), 1e-13 * std::max(1.0, f.norm())) << "symmetric in its ends";
    }
    EXPECT_LE((f - conservative(a)).norm(), 1e-12 * std::max(1.0, f.norm())) << "at rest it is the force";
  });
}

TEST_F(Derivatives, ConstraintsAndExternalForceAreAllTheForce) {
  forAll([&](const State& s, unsigned) {
    const Constraints& constraints = *system_->constraints();
    std::vector<double> f(s.x.size());
    constraints.externalForce(s.t, s.x, s.v, s.z, f);
    constraints.evaluate(s.t, s.x, s.z, [&](std::span<const Constraint> some) {
      for (const Constraint& c : some) {
        double rate = 0.0;
        for (int i = 0; i < c.count; ++i) {
          const auto e = static_cast<std::size_t>(i);
          rate += c.gradient[e] * s.v[static_cast<std::size_t>(c.lane[e])];
        }
        for (int i = 0; i < c.count; ++i) {
          const auto e = static_cast<std::size_t>(i);
          f[static_cast<std::size_t>(c.lane[e])] -= (c.stiffness * c.value + c.damping * rate) * c.gradient[e];
        }
      }
    });
    // A damped contact never pulls and its obstacle may move: a Constraint knows neither.
    if (!constraints.leftOut().empty() || is("damped_") || is("friction_")) return;
    const Eigen::VectorXd sum = unknownsOf([&](Out to) { std::ranges::copy(f, to.begin()); });
    EXPECT_LE((sum - force(s)).norm(), 1e-12 * std::max(1.0, sum.norm()));
  });
}

}  // namespace
}  // namespace muelle::engine::testing
