#include "engine/control/simulate.h"
#include "engine/integrators/catalogue.h"
#include "engine/statics/equilibrium.h"
#include "lab/published/models.h"
#include "lab/published/problem.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::published {

using namespace engine;

namespace {

/// A node of mass m in the x-z plane, held by springs from pinned points at rest length.
Model inPlane(const Vec3& x, double m, const std::vector<std::pair<Vec3, double>>& anchors) {
  Model model;
  model.dimension = 2;
  model.nodes.push_back({.x = x, .m = m});
  for (const auto& [anchor, k] : anchors) {
    model.springs.push_back(
        {.a = 0, .b = static_cast<int>(std::ssize(model.nodes)), .k = k, .L0 = (anchor - x).norm()});
    model.nodes.push_back({.x = anchor, .pinned = true});
  }
  return model;
}

Problem unequalSprings() {
  // Where the sum of forces vanishes, by Newton's method in 40 digits; the book's optimiser stopped before.
  const std::vector<Quantity> quantities = {
      {"strain energy", "N cm", "24.01", 24.011634218879314},
      {.what = "u across the line", .unit = "cm", .printed = "8.631", .exact = 8.632066133346838, .printedIsOff = true},
      {.what = "u along the line", .unit = "cm", .printed = "4.533", .exact = 4.531906698981502, .printedIsOff = true}};
  return {"VM9",
          "Two unequal springs, pulled aside by as much as they are long",
          "Ansys Mechanical APDL Verification Manual, VM9; G. N. Vanderplaats, Numerical Optimization Techniques for "
          "Engineering Design (1984), p. 72, ex. 3-1",
          "k1 = 8, k2 = 1 N/cm, each 10 cm long, in a line; F = 5 sqrt(2) N at 45 degrees between them",
          "equilibrium; the force as the weight of a unit mass",
          quantities,
          [] {
            Model model = inPlane({0.0, 0.0, 10.0}, 1.0, {{Vec3(0.0, 0.0, 0.0), 1.0}, {Vec3(0.0, 0.0, 20.0), 8.0}});
            model.gravity = Vec3(5.0, 0.0, 5.0);
            // Along the line alone the forces would balance on a saddle; off it they do where the energy is least.
            model.nodes[0].x = Vec3(1.0, 0.0, 11.0);
            const std::unique_ptr<ModelSystem> system = build(model);
            const StaticResult rest = equilibrium(*system, system->initialState());
            if (!rest.converged) throw std::runtime_error(rest.message);
            const Vec3 x = system->position(rest.state, 0);
            const double low = x.norm() - 10.0;
            const double high = (Vec3(0.0, 0.0, 20.0) - x).norm() - 10.0;
            return std::vector<double>{0.5 * low * low + 4.0 * high * high, x.x(), x.z() - 10.0};
          }};
}

/// The period of a pendulum: 4 K(sin(60/2)) / omega, K by the arithmetic-geometric mean.
double pendulumPeriod(double L, double g, double angle) {
  double a = 1.0;
  double b = std::cos(0.5 * angle);
  for (int i = 0; i < 8; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 2.0 * pi * std::sqrt(L / g) / a;
}

Problem pendulum() {
  const double period = pendulumPeriod(1.0, 9.81, pi / 3.0);
  return {
      "MotionSolve 2",
      "A pendulum let go at 60 degrees",
      "Altair MotionSolve verification, problem 2; F. P. Beer, E. R. Johnston et al., Vector Mechanics for Engineers, "
      "12th ed., p. 1357",
      "a cord of 1 m (g is not stated; 9.81 m/s^2 here)",
      "1 kg, the cord a spring of 1e7 N/m, which lengthens it by up to 2 m g / k = 2e-6",
      {{.what = "period", .unit = "s", .printed = "2.153", .exact = period, .tolerance = 3e-6}},
      [period] {
        Model model = inPlane({std::sin(pi / 3.0), 0.0, -std::cos(pi / 3.0)}, 1.0, {{Vec3::Zero(), 1e7}});
        model.gravity = Vec3(0.0, 0.0, -9.81);
        const std::unique_ptr<ModelSystem> system = build(model);
        RunOptions options;
        // Four times as long as to the first passage through the lowest point: near it x is linear in time.
        options.duration = 0.25 * period;
        options.fixedStep = true;
        options.h = 2e-5;
        options.outputInterval = options.duration;
        const RunResult result = simulate(*system, *makeMethod("dop853"), system->initialState(), options);
        const Vec3 x = system->position(result.last, 0);
        const Vec3 v = system->velocity(result.last, 0);
        return std::vector<double>{4.0 * (result.last.t - x.x() / v.x())};
      }};
}

Problem stop() {
  const double w = std::sqrt(10100.0);
  const double contact = pi / w;
  const std::vector<Quantity> quantities = {
      {.what = "first greatest force, when",
       .unit = "s",
       .printed = "0.01563",
       .exact = 0.5 * contact,
       .tolerance = 1e-6},
      {.what = "greatest force",
       .unit = "N",
       .printed = "9950.0",
       .exact = 1e6 / w,
       .tolerance = 1e-6,
       .printedIsOff = true},
      {.what = "second greatest force, when",
       .unit = "s",
       .printed = "0.361",
       .exact = 1.5 * contact + 0.1 * pi,
       .tolerance = 1e-6},
      {.what = "length of a shock", .unit = "s", .printed = "0.03126", .exact = contact, .tolerance = 1e-6},
      {.what = "impulse of a shock",
       .unit = "N s",
       .printed = "198.05",
       .exact = 2e6 / 10100.0,
       .tolerance = 1e-6,
       .printedIsOff = true},
      {.what = "speed at the second shock", .unit = "m/s", .printed = "1.0", .exact = 1.0}};
  return {"SDND101",
          "A mass strikes an elastic stop, again and again",
          "Code_Aster, SDND101 (V5.01.101, file sdnd101a)",
          "m = 100 kg, k = 1e4 N/m; a stop of 1e6 N/m where the spring is at rest; v(0) = 1 m/s towards it",
          "",
          quantities,
          [] {
            Model model = row({100.0}, {{-1, 0, 1e4}});
            model.nodes[0].v[0] = 1.0;
            Obstacle wall;
            wall.centre = model.nodes[0].x;
            wall.normal = -Vec3::UnitX();
            wall.material = {.k = 1e6};
            model.obstacles.push_back(wall);
            const double dt = 1e-5;
            const std::vector<Motion1D> motion = motionOf(model, 0, 0.4, dt, 2e-4);
            std::vector<double> turns, crossings, speeds;
            double deepest = 0.0;
            double impulse = 0.0;
            for (std::size_t i = 1; i < motion.size(); ++i) {
              const Motion1D &p = motion[i - 1], &q = motion[i];
              const auto at = [&](double before, double after) {
                return dt * (static_cast<double>(i - 1) + before / (before - after));
              };
              deepest = std::max(deepest, q.x);
              if (p.v > 0.0 && q.v <= 0.0 && q.x > 0.0) turns.push_back(at(p.v, q.v));
              if (i > 1 && p.x * q.x < 0.0) {
                crossings.push_back(at(p.x, q.x));
                speeds.push_back(std::abs(p.v));
              }
              if (crossings.empty()) impulse += 0.5 * dt * 1e6 * (std::max(p.x, 0.0) + std::max(q.x, 0.0));
            }
            return std::vector<double>{turns.at(0), 1e6 * deepest, turns.at(1), crossings.at(0), impulse, speeds.at(1)};
          }};
}

Problem rubbing() {
  // A turn after every half period, each 2 mu m g / k = 0.2 mm less far; along y, at 45 degrees.
  std::vector<Quantity> quantities;
  const char* printed[] = {"-4.596e-4", "3.182e-4", "-1.768e-4", "3.536e-5"};
  for (int i = 1; i <= 4; ++i) {
    const double exact = (i % 2 == 0 ? 1.0 : -1.0) * (0.85e-3 - 2e-4 * i) / std::sqrt(2.0);
    quantities.push_back({.what = fmt::format("y after {} half periods", i),
                          .unit = "m",
                          .printed = printed[i - 1],
                          .exact = exact,
                          .tolerance = 1e-4});
  }
  quantities[0].what = "y after 1 half period";
  return {"SDND100",
          "A mass rubs on a plane until it stays",
          "Code_Aster, SDND100 (V5.01.100, file sdnd100a)",
          "m = 1 kg, k = 1e4 N/m, g = 10 m/s^2, mu = 0.1; let go 0.85 mm from the middle, at 45 degrees in the plane",
          "friction sticks here by a spring of 1e10 N/m, which gives way by 1e-10 m",
          quantities,
          [] {
            std::vector<double> values;
            for (int i = 1; i <= 4; ++i) {
              const double depth = 1e-5;  // under the weight of 10 N
              Model model = inPlane({1.0, 0.0, -depth}, 1.0, {{Vec3(0.0, 0.0, -depth), 1e4}});
              model.nodes[0].x.x() += 0.85e-3;
              model.gravity = Vec3(0.0, 0.0, -10.0);
              Obstacle ground;
              ground.material = {.k = 1e6, .mu = 0.1, .kTangential = 1e10};
              model.obstacles.push_back(ground);
              const std::unique_ptr<ModelSystem> system = build(model);
              RunOptions options;
              options.duration = i * pi / 100.0;
              options.fixedStep = true;
              options.h = 2e-6;
              options.outputInterval = options.duration;
              options.checkStability = false;
              const RunResult result = simulate(*system, *makeMethod("dop853"), system->initialState(), options);
              if (result.failed()) throw std::runtime_error(result.trajectory.stop.message);
              values.push_back((system->position(result.last, 0).x() - 1.0) / std::sqrt(2.0));
            }
            return values;
          }};
}

}  // namespace

std::vector<Problem> nonlinearProblems() { return {unequalSprings(), pendulum(), stop(), rubbing()}; }

}  // namespace muelle::published
