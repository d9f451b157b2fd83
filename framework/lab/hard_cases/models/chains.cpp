#include "lab/hard_cases/models.h"
#include "lab/hard_cases/models/parts.h"

#include <cmath>
#include <numbers>

namespace muelle::hard_cases {

Model hangingChain(double dragPerMass) {
  constexpr int n = 100;
  Model model = onLine(g);
  for (int i = 0; i < n; ++i) {
    model.nodes.push_back(at(Vec3(-0.01 * (i + 1), 0, 0), 0.01));
    model.nodes.back().drag = dragPerMass * 0.01;
    model.springs.push_back({.a = i == 0 ? n : i - 1, .b = i, .k = 1000.0, .L0 = 0.01});
  }
  model.nodes.push_back(anchor(Vec3::Zero()));
  return model;
}

Model catenary(double sag, double dragPerMass) {
  constexpr int springs = 20, n = springs - 1;
  Model model = inPlane();
  for (int i = 0; i < n; ++i) {
    const double s = (i + 1.0) / springs;
    model.nodes.push_back(at(Vec3(s, 0, -4.0 * sag * s * (1.0 - s)), 0.1));
    model.nodes.back().drag = dragPerMass * 0.1;
  }
  model.nodes.push_back(anchor(Vec3::Zero()));
  model.nodes.push_back(anchor(Vec3::UnitX()));
  for (int j = 0; j < springs; ++j) {
    model.springs.push_back({.a = j == 0 ? n : j - 1, .b = j == n ? n + 1 : j, .k = 1000.0, .L0 = 0.06});
  }
  return model;
}

namespace {

/// 50 nodes, `spacing` apart along x, between anchors, k = 100, L0 = 1.
Model chainBetweenAnchors(Model model, double spacing) {
  constexpr int n = 50;
  for (int i = 1; i <= n; ++i) model.nodes.push_back(at(Vec3(spacing * i, 0, 0)));
  model.nodes.push_back(anchor(Vec3::Zero()));
  model.nodes.push_back(anchor(Vec3(spacing * (n + 1), 0, 0)));
  for (int j = 0; j <= n; ++j) {
    model.springs.push_back({.a = j == 0 ? n : j - 1, .b = j == n ? n + 1 : j, .k = 100.0, .L0 = 1.0});
  }
  return model;
}

}  // namespace

Model longitudinalChain() {
  Model model = chainBetweenAnchors(onLine(), 1.0);
  for (int i = 1; i <= 50; ++i) {
    const double s = i * std::numbers::pi / 51.0;
    model.nodes[static_cast<std::size_t>(i - 1)].x[0] += 0.01 * (std::sin(s) + std::sin(50.0 * s));
  }
  return model;
}

Model transverseChain() {
  Model model;
  model.dimension = 2;
  model = chainBetweenAnchors(model, 1.1);
  for (int i = 1; i <= 50; ++i) {
    model.nodes[static_cast<std::size_t>(i - 1)].x[2] = 1e-6 * std::sin(i * std::numbers::pi / 51.0);
  }
  return model;
}

Model stiffnessRatio() {
  Model model = onLine();
  model.nodes = {at(Vec3(1, 0, 0)), at(Vec3(2.1, 0, 0)), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 2, .k = 1e6, .L0 = 1.0}, {.a = 0, .b = 1, .k = 1.0, .L0 = 1.0}};
  return model;
}

Model heavyBelowLight() {
  Model model = onLine(g);
  model.nodes = {at(Vec3(-1, 0, 0)), at(Vec3(-2, 0, 0), 1e6), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 2, .k = 1e8, .L0 = 1.0}, {.a = 0, .b = 1, .k = 1e8, .L0 = 1.0}};
  return model;
}

Model heavySwing() {
  Model model = inPlane();
  model.nodes = {at(Vec3(0.6, 0, -0.8)), at(Vec3(1.2, 0, -1.6), 1e6), anchor(Vec3::Zero())};
  model.springs = {{.a = 0, .b = 2, .k = 1e8, .L0 = 1.0}, {.a = 0, .b = 1, .k = 1e8, .L0 = 1.0}};
  return model;
}

}  // namespace muelle::hard_cases
