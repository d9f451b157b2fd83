#include "tools.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::plots::property_mean_height {

namespace {

constexpr double wanted = 2.0, stiffness = 8000.0;
constexpr double heights[] = {1.3, 1.4, 1.5, 1.8, 2.0}, masses[] = {70.0, 30.0, 55.0, 40.0, 90.0};

/// Five pupils, light and heavy, short and tall, whose mean height should be `wanted`: E = k/2 (mean - wanted)^2.
engine::Model pupils(double drag) {
  engine::Model model;
  model.dimension = 1;
  engine::ModelProperty mean;
  mean.k = stiffness;
  mean.p0 = wanted;
  for (int i = 0; i < 5; ++i) {
    model.nodes.push_back({.x = Vec3(heights[i], 0.0, 0.0), .m = masses[i], .drag = drag});
    mean.nodes.push_back(i);
    mean.weights.push_back(Vec3(0.2, 0.0, 0.0));
  }
  model.properties.push_back(mean);
  return model;
}

struct Heights {
  std::vector<double> t, mean;
  std::vector<std::vector<double>> each;
};

Heights heightsOver(double duration, double drag) {
  const auto system = engine::build(pupils(drag));
  const Trajectory trajectory = run(*system, "runge_kutta_4", 0.01, duration).trajectory;
  Heights found{trajectory.t, std::vector<double>(trajectory.t.size(), 0.0), {}};
  for (int i = 0; i < 5; ++i) {
    found.each.push_back(along(trajectory, [&](const State& s) { return system->position(s, i).x(); }));
    for (std::size_t j = 0; j < found.mean.size(); ++j) found.mean[j] += 0.2 * found.each.back()[j];
  }
  return found;
}

/// Each pupil is pushed by -k (mean - wanted) / 5, so the mean swings: omega^2 = k / 25 times the sum of 1 / m.
double angularFrequency() {
  double sum = 0.0;
  for (const double m : masses) sum += 1.0 / m;
  return std::sqrt(stiffness / 25.0 * sum);
}

void addMean(Figure& figure) {
  const double duration = 3.0, omega = angularFrequency(), start = 1.6;
  const Heights found = heightsOver(duration, 0.0);
  std::vector<double> t, mean, exact;
  for (std::size_t i = 0; i < found.t.size(); i += 10) {
    t.push_back(found.t[i]);
    mean.push_back(found.mean[i]);
  }
  for (const double time : found.t) exact.push_back(wanted + (start - wanted) * std::cos(omega * time));
  auto panel = figure.panel("height [m]");
  panel.heading(fmt::format("without drag the mean swings about h₀ = {:.0f} m", wanted));
  panel.points("mean", t, mean).colour(1);
  panel.reference("h₀ + A cos ωt", found.t, exact).structure("", {0.0, duration}, {wanted, wanted});
  panel.xRange(0.0, duration).yRange(1.2, 2.8);
}

void addPupils(Figure& figure, double drag) {
  const double duration = 8.0;
  const Heights found = heightsOver(duration, drag);
  auto panel = figure.panel("height [m]");
  panel.heading("with drag it rests there, each pupil elsewhere");
  for (std::size_t i = 0; i < 5; ++i) {
    panel.line(i == 0 ? "each pupil" : "", found.t, found.each[i]).colour(5);
    panel.note(6.6, found.each[i].back() + 0.045, fmt::format("{} kg", masses[i]));
  }
  panel.line("mean", found.t, found.mean).colour(1).structure("", {0.0, duration}, {wanted, wanted});
  panel.xRange(0.0, duration).yRange(1.2, 2.8);
}

}  // namespace

/// Slide "Fuerzas y Energías": an energy that is least where a property holds gives a force towards it.
Figure property_mean_height() {
  Figure figure("property_mean_height",
                "An energy of the mean height moves the mean to 2 m, and prescribes no single one", "time [s]");
  figure.slide(2);
  addMean(figure);
  addPupils(figure, 100.0);
  return figure;
}

}  // namespace muelle::plots::property_mean_height
