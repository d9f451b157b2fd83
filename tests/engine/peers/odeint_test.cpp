/// \file
/// Independent agreement: scenes built by the engine and run by its methods, against Boost.odeint on forces that are
/// written here again, from the formulas of the lecture. No line is shared.

#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/model/model_system.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <Eigen/Geometry>
#include <functional>
#include <numbers>

namespace muelle::engine {
namespace {

constexpr double g = 9.81;

/// Positions and velocities of all nodes and the forces on them, as the peer sees them.
struct Peer {
  std::vector<Vec3> x, v, F;

  void gravity(std::size_t i, double m) { F[i][2] -= m * g; }
  void drag(std::size_t i, double d) { F[i] -= d * v[i]; }
  void spring(std::size_t a, std::size_t b, double k, double L0, double relative = 0.0, double projected = 0.0) {
    const Vec3 d = x[a] - x[b], w = v[a] - v[b];
    const double L = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double alongSpeed = (w[0] * d[0] + w[1] * d[1] + w[2] * d[2]) / L;
    const Vec3 pull = d * ((-k * (L - L0) - projected * alongSpeed) / L) - relative * w;
    F[a] += pull;
    F[b] -= pull;
  }
};

using Forces = std::function<void(double t, Peer&)>;

/// The final state by Fehlberg's method of order 7(8) at a tolerance of 1e-14. Fixed nodes have an infinite mass.
Peer byOdeint(const Model& model, double duration, const Forces& forces) {
  namespace odeint = boost::numeric::odeint;
  using Numbers = std::vector<double>;
  const std::size_t n = model.nodes.size();
  const auto read = [n](const Numbers& y, Peer& peer) {
    peer.x.resize(n);
    peer.v.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      peer.x[i] = Vec3(y[6 * i], y[6 * i + 1], y[6 * i + 2]);
      peer.v[i] = Vec3(y[6 * i + 3], y[6 * i + 4], y[6 * i + 5]);
    }
  };
  Numbers y(6 * n);
  for (std::size_t i = 0; i < n; ++i) {
    const ModelNode& node = model.nodes[i];
    for (std::size_t c = 0; c < 3; ++c) {
      y[6 * i + c] = node.x[static_cast<Eigen::Index>(c)];
      y[6 * i + 3 + c] = node.pinned ? 0.0 : node.v[static_cast<Eigen::Index>(c)];
    }
  }
  Peer work;
  const auto slope = [&](const Numbers& state, Numbers& rate, double t) {
    read(state, work);
    work.F.assign(n, Vec3::Zero());
    forces(t, work);
    for (std::size_t i = 0; i < n; ++i) {
      const bool fixed = model.nodes[i].pinned;
      for (std::size_t c = 0; c < 3; ++c) {
        rate[6 * i + c] = state[6 * i + 3 + c];
        rate[6 * i + 3 + c] = fixed ? 0.0 : work.F[i][static_cast<Eigen::Index>(c)] / model.nodes[i].m;
      }
    }
  };
  odeint::integrate_adaptive(odeint::make_controlled(1e-14, 1e-14, odeint::runge_kutta_fehlberg78<Numbers>()), slope, y,
                             0.0, duration, 1e-4);
  Peer end;
  read(y, end);
  return end;
}

/// The largest difference from the peer, over the largest position and over the largest velocity.
void expectAgreement(const Model& model, double duration, const Forces& forces, const std::vector<std::string>& methods,
                     double h) {
  const Peer peer = byOdeint(model, duration, forces);
  const auto system = build(model);
  for (const std::string& id : methods) {
    const auto method = makeMethod(id);
    RunOptions options;
    options.duration = duration;
    options.h = method->info().adaptive ? 0.0 : h;
    options.tolerance = {.relative = 1e-14};
    options.outputInterval = duration;
    options.largestStep = 0.1;  // asked for where a force depends on time without declared times
    options.checkNumericalDamping = options.checkStability = false;
    const RunResult run = simulate(*system, *method, system->initialState(), options);
    ASSERT_FALSE(run.failed()) << id << ": " << run.trajectory.stop.message;
    double dx = 0.0, dv = 0.0, x = 1e-3, v = 1e-3;
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      if (model.nodes[i].pinned || model.nodes[i].motion >= 0) continue;
      const int node = static_cast<int>(i);
      dx = std::max(dx, (system->position(run.last, node) - peer.x[i]).norm());
      dv = std::max(dv, (system->velocity(run.last, node) - peer.v[i]).norm());
      x = std::max(x, peer.x[i].norm());
      v = std::max(v, peer.v[i].norm());
    }
    EXPECT_LT(dx / x, 1e-9) << id;
    EXPECT_LT(dv / v, 1e-9) << id;
    ::testing::Test::RecordProperty(id, fmt::format("position {:.1e}, velocity {:.1e}, {} force evaluations", dx / x,
                                                    dv / v, run.work.forceEvaluations));
  }
}

ModelNode node(Vec3 x, Vec3 v = Vec3::Zero(), double m = 1.0) {
  ModelNode result;
  result.x = x;
  result.v = v;
  result.m = m;
  return result;
}

ModelNode pin(Vec3 x) {
  ModelNode result = node(x);
  result.pinned = true;
  return result;
}

TEST(Odeint, ElasticPendulumInThePlane) {  // hard case H04, regular
  Model model;
  model.dimension = 2;
  model.gravity = {0, 0, -g};
  model.nodes = {pin({0, 0, 0}), node({0.3, 0, -1.0})};
  model.springs = {{0, 1, 100.0, 1.0}};
  expectAgreement(
      model, 10.0,
      [](double, Peer& p) {
        p.gravity(1, 1.0);
        p.spring(0, 1, 100.0, 1.0);
      },
      {"dop853", "dormand_prince_5", "nystrom8", "nystrom12", "kahan_li_8"}, 1e-3);
}

TEST(Odeint, FreeFlyingTriangle) {  // hard case H08
  Model model;
  model.nodes = {node({0, 0, 0}, {0.5, 0, 1}, 1.0), node({1.2, 0, 0}, {-0.3, 0.8, 0}, 2.0),
                 node({0.4, 0.9, 0.1}, {0, -0.5, 0.2}, 3.0)};
  model.springs = {{0, 1, 100.0, 1.0}, {1, 2, 200.0, 1.0}, {2, 0, 150.0, 1.0}};
  expectAgreement(
      model, 5.0,
      [](double, Peer& p) {
        p.spring(0, 1, 100.0, 1.0);
        p.spring(1, 2, 200.0, 1.0);
        p.spring(2, 0, 150.0, 1.0);
      },
      {"dop853", "nystrom12", "kahan_li_8"}, 1e-3);
}

TEST(Odeint, DumbbellWithEachDamping) {  // hard case H07
  for (const bool projected : {true, false}) {
    Model model;
    model.nodes = {node({0.9, 0, 0}, {0, 3.6, 0}, 1.0), node({-0.3, 0, 0}, {0, -1.2, 0}, 3.0)};
    ModelSpring spring{0, 1, 252.0, 1.0};
    (projected ? spring.dProjected : spring.dRelative) = 0.7;
    model.springs = {spring};
    expectAgreement(
        model, 5.0,
        [projected](double, Peer& p) { p.spring(0, 1, 252.0, 1.0, projected ? 0.0 : 0.7, projected ? 0.7 : 0.0); },
        {"dop853", "dormand_prince_5"}, 0.0);
  }
}

TEST(Odeint, HangingChainWithDragSwingsDown) {
  constexpr std::size_t n = 10;
  Model model;
  model.gravity = {0, 0, -g};
  model.nodes.push_back(pin({0, 0, 0}));
  for (std::size_t i = 1; i <= n; ++i) {
    model.nodes.push_back(node({0.1 * static_cast<double>(i), 0.01 * static_cast<double>(i * i % 7), 0}));
    model.nodes.back().m = 0.1;
    model.nodes.back().drag = 0.02;
    model.springs.push_back({static_cast<int>(i) - 1, static_cast<int>(i), 500.0, 0.1, 0.0, 0.3});
  }
  expectAgreement(
      model, 1.0,
      [](double, Peer& p) {
        for (std::size_t i = 1; i <= n; ++i) {
          p.gravity(i, 0.1);
          p.drag(i, 0.02);
          p.spring(i - 1, i, 500.0, 0.1, 0.0, 0.3);
        }
      },
      {"dop853", "dormand_prince_5"}, 0.0);
}

TEST(Odeint, BendingStripInThePlane) {
  constexpr std::size_t n = 6;
  Model model;
  model.dimension = 2;
  model.gravity = {0, 0, -g};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 place{0.2 * static_cast<double>(i), 0, 0.01 * static_cast<double>(i * i)};
    model.nodes.push_back(i < 2 ? pin(place) : node(place, Vec3::Zero(), 0.2));
    if (i > 0) model.springs.push_back({static_cast<int>(i) - 1, static_cast<int>(i), 800.0, 0.2});
    if (i > 1) {
      model.angles.push_back({static_cast<int>(i) - 2, static_cast<int>(i) - 1, static_cast<int>(i), 3.0, 0.0});
    }
  }
  // Turning angle theta = arg(c - b) - arg(b - a); d arg(u) = (u_x du_z - u_z du_x) / |u|^2.
  const auto bend = [](Peer& p, std::size_t a, std::size_t b, std::size_t c, double k) {
    const Vec3 u = p.x[b] - p.x[a], w = p.x[c] - p.x[b];
    const double theta = std::remainder(std::atan2(w[2], w[0]) - std::atan2(u[2], u[0]), 2.0 * std::numbers::pi);
    const Vec3 du = Vec3(-u[2], 0, u[0]) / (u[0] * u[0] + u[2] * u[2]);
    const Vec3 dw = Vec3(-w[2], 0, w[0]) / (w[0] * w[0] + w[2] * w[2]);
    p.F[a] -= k * theta * du;
    p.F[c] -= k * theta * dw;
    p.F[b] += k * theta * (du + dw);
  };
  expectAgreement(
      model, 1.0,
      [&](double, Peer& p) {
        for (std::size_t i = 2; i < n; ++i) p.gravity(i, 0.2);
        for (std::size_t i = 1; i < n; ++i) p.spring(i - 1, i, 800.0, 0.2);
        for (std::size_t i = 2; i < n; ++i) bend(p, i - 2, i - 1, i, 3.0);
      },
      {"dop853", "nystrom12"}, 0.0);
}

TEST(Odeint, InvertedTriangleWithASignedArea) {  // hard case H15
  Model model;
  model.dimension = 2;
  model.nodes = {pin({-0.75, 0, 0}), pin({0.75, 0, 0}), node({0.02, 0, -1})};
  model.springs = {{0, 2, 10.0, 1.25}, {1, 2, 10.0, 1.25}};
  model.areas = {{0, 1, 2, 100.0, 0.75}};
  expectAgreement(
      model, 1.0,
      [](double, Peer& p) {
        p.spring(0, 2, 10.0, 1.25);
        p.spring(1, 2, 10.0, 1.25);
        const Vec3 u = p.x[1] - p.x[0], w = p.x[2] - p.x[0];
        const double area = 0.5 * (u[0] * w[2] - u[2] * w[0]);
        p.F[2] -= 100.0 * (area - 0.75) * 0.5 * Vec3(-u[2], 0, u[0]);
      },
      {"dop853", "nystrom12"}, 0.0);
}

TEST(Odeint, ThrownTetrahedronThatKeepsItsVolumeAndItsMeanHeight) {
  Model model;
  model.gravity = {0, 0, -g};
  model.nodes = {node({0, 0, 0}, {1, 0, 3}, 0.5), node({1, 0, 0}, {0, 1, 3}, 0.7), node({0, 1, 0.1}, {0, 0, 2}, 0.4),
                 node({0.2, 0.1, 1}, {0.5, -0.5, 3}, 0.6)};
  for (int a = 0; a < 4; ++a) {
    for (int b = a + 1; b < 4; ++b) model.springs.push_back({a, b, 60.0, 1.1, 0.0, 0.2});
  }
  model.volumes = {{0, 1, 2, 3, 900.0, 0.2}};
  ModelProperty height;
  height.nodes = {0, 1, 2, 3};
  height.weights.assign(4, Vec3(0, 0, 0.25));
  height.k = 20.0;
  height.p0 = 0.8;
  model.properties = {height};
  expectAgreement(
      model, 2.0,
      [](double, Peer& p) {
        const double m[] = {0.5, 0.7, 0.4, 0.6};
        double mean = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
          p.gravity(i, m[i]);
          mean += 0.25 * p.x[i][2];
          for (std::size_t j = i + 1; j < 4; ++j) p.spring(i, j, 60.0, 1.1, 0.0, 0.2);
        }
        for (std::size_t i = 0; i < 4; ++i) p.F[i][2] -= 20.0 * (mean - 0.8) * 0.25;
        const Vec3 b = p.x[1] - p.x[0], c = p.x[2] - p.x[0], d = p.x[3] - p.x[0];
        const Vec3 gb = c.cross(d) / 6.0, gc = d.cross(b) / 6.0, gd = b.cross(c) / 6.0;
        const double push = -900.0 * (b.dot(c.cross(d)) / 6.0 - 0.2);
        p.F[1] += push * gb;
        p.F[2] += push * gc;
        p.F[3] += push * gd;
        p.F[0] -= push * (gb + gc + gd);
      },
      {"dop853", "dormand_prince_5"}, 0.0);
}

TEST(Odeint, MassOnAShakenAnchorUnderATimeDependentForce) {
  Model model;
  model.gravity = {0, 0, -g};
  Motion shake;
  shake.position = [](double t, int) { return Vec3(0.1 * std::sin(3.0 * t), 0.05 * std::sin(2.0 * t), 0.0); };
  shake.velocity = [](double t, int) { return Vec3(0.3 * std::cos(3.0 * t), 0.1 * std::cos(2.0 * t), 0.0); };
  model.motions = {shake};
  model.nodes = {node({0, 0, 0}), node({0, 0.3, -1.0})};
  model.nodes[0].motion = 0;
  model.springs = {{0, 1, 80.0, 1.0, 0.4, 0.0}};
  ModelExternalForce wind;
  wind.nodes = {1};
  wind.force = [](double t, int) { return Vec3(2.0 * std::sin(5.0 * t), 0.0, std::cos(t)); };
  model.externalForces = {wind};
  expectAgreement(
      model, 3.0,
      [&](double t, Peer& p) {
        p.x[0] = Vec3(0.1 * std::sin(3.0 * t), 0.05 * std::sin(2.0 * t), 0.0);
        p.v[0] = Vec3(0.3 * std::cos(3.0 * t), 0.1 * std::cos(2.0 * t), 0.0);
        p.gravity(1, 1.0);
        p.spring(0, 1, 80.0, 1.0, 0.4, 0.0);
        p.F[1] += Vec3(2.0 * std::sin(5.0 * t), 0.0, std::cos(t));
      },
      {"dop853", "dormand_prince_5"}, 0.0);
}

}  // namespace
}  // namespace muelle::engine
