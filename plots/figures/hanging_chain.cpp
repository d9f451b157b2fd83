#include "engine/scene/generators.h"
#include "engine/statics/equilibrium.h"
#include "tools.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::plots::hanging_chain {

namespace {

const double span = 1.0, length = 1.5, mass = 1.0, g = 9.81;

/// A chain of n springs between two nails; k is that of the whole chain, so that n only refines.
engine::Model chain(int n, double k) {
  engine::Model model;
  model.dimension = 2;
  model.gravity = Vec3(0.0, 0.0, -g);
  engine::ChainShape shape{.n = n + 1, .from = Vec3::Zero(), .to = Vec3(span, 0.0, 0.0), .L0 = length / n, .sag = 0.4};
  shape.spring.k = k * n;
  engine::addChain(model, shape);
  for (auto& node : model.nodes) node.m = mass / n;
  model.nodes.front().pinned = model.nodes.back().pinned = true;
  return model;
}

struct Hanging {
  std::vector<double> x, z;
  double residual = 0.0;  ///< [N]
};

Hanging hang(int n, double k) {
  const auto system = engine::build(chain(n, k));
  const engine::StaticResult rest = engine::equilibrium(*system, system->initialState());
  Hanging shape;
  shape.residual = rest.residual;
  for (int i = 0; i <= n; ++i) {
    shape.x.push_back(system->position(rest.state, i).x());
    shape.z.push_back(system->position(rest.state, i).z());
  }
  return shape;
}

/// The chain that does not stretch: z = a (cosh((x - span/2) / a) - cosh(span / (2 a))), 2 a sinh(span / (2 a)) =
/// length.
class Catenary {
 public:
  Catenary() {
    double low = 0.05, high = 10.0;
    for (int i = 0; i < 100; ++i) {
      a_ = 0.5 * (low + high);
      (2.0 * a_ * std::sinh(span / (2.0 * a_)) > length ? low : high) = a_;
    }
  }
  double z(double x) const { return a_ * (std::cosh((x - 0.5 * span) / a_) - std::cosh(span / (2.0 * a_))); }
  /// How far the nodes, at equal parts of the length, are off their places on the curve, at most.
  double distance(const Hanging& shape) const {
    const double n = static_cast<double>(shape.x.size() - 1);
    double most = 0.0;
    for (std::size_t i = 0; i < shape.x.size(); ++i) {
      const double s = length * (static_cast<double>(i) / n - 0.5);
      const double x = 0.5 * span + a_ * std::asinh(s / a_);
      most = std::max(most, std::hypot(shape.x[i] - x, shape.z[i] - z(x)));
    }
    return most;
  }

 private:
  double a_ = 1.0;
};

}  // namespace

/// Slide "Todo junto...", at rest: the sum of weight and spring forces is 0 at every node, and a stiff chain hangs as
/// the catenary does.
Figure hanging_chain() {
  const Catenary catenary;
  Figure figure("hanging_chain", "At rest the forces on every node sum to zero: a stiff chain is a catenary", "x [m]");
  figure.slide(2);
  auto shapes = figure.panel("z [m]");
  shapes.heading("20 springs between two nails");
  std::vector<double> curve;
  for (const double x : linear(0.0, span, 200)) curve.push_back(catenary.z(x));
  shapes.reference("catenary", linear(0.0, span, 200), curve);
  for (const double k : {1e5, 50.0, 15.0}) {
    const Hanging shape = hang(20, k);
    shapes.linePoints(k < 1e5 ? fmt::format("k = {} N/m", k) : "k = 10⁵ N/m", shape.x, shape.z);
  }
  shapes.equalAxes();

  auto distances = figure.panel("distance from the catenary [m]");
  distances.heading("stretch first, then the number of springs").xLabel("k of the whole chain [N/m]");
  const std::vector<double> k = logarithmic(10.0, 1e5, 17);
  double residual = 0.0;
  for (const int n : {10, 40, 160}) {
    std::vector<double> distance;
    for (const double stiffness : k) {
      const Hanging shape = hang(n, stiffness);
      residual = std::max(residual, shape.residual);
      distance.push_back(catenary.distance(shape));
    }
    distances.line(fmt::format("{} springs", n), k, distance);
  }
  distances.logX().logY().xRange(10, 1e5).yRange(1e-6, 1).note(
      12, 3e-6, fmt::format("largest sum of forces: {} N", asPower(residual)));
  return figure;
}

}  // namespace muelle::plots::hanging_chain
