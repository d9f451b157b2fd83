#include "figure_list.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace muelle::plots {
namespace {

constexpr double g = 9.81;

Figure draw(const std::string& name) {
  for (const LectureFigure& figure : lectureFigures()) {
    if (figure.name == name) return figure.draw();
  }
  throw std::runtime_error("no figure " + name);
}

/// The curves of a panel that are drawn with a pen, in their order.
std::vector<Series> curvesOf(const Panel& panel, Pen pen) {
  std::vector<Series> found;
  std::copy_if(panel.series.begin(), panel.series.end(), std::back_inserter(found),
               [pen](const Series& s) { return s.pen == pen; });
  return found;
}

double valueAt(const Series& series, double x) {
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    if (std::abs(series.x[i] - x) < 1e-9) return series.y[i];
  }
  throw std::runtime_error("nothing drawn there");
}

/// Force [N] of a spring from b on a, in the plane.
std::pair<double, double> hooke(double ax, double ay, double bx, double by, double k, double L0) {
  const double L = std::hypot(ax - bx, ay - by);
  return {-k * (L - L0) * (ax - bx) / L, -k * (L - L0) * (ay - by) / L};
}

// Where no other tolerance is derived, numbers come from a closed form of a few terms: round-off of some 1e2 units.
constexpr double roundOff = 1e-12;

TEST(FigureHookesLaw1D, HasTheSlopeMinusKAndNoForceAtTheRestLength) {
  const Figure figure = draw("hookes_law_1d");
  const std::vector<Series> lines = curvesOf(figure.panels().at(0), Pen::Line);
  const double stiffness[] = {50.0, 100.0, 200.0};
  ASSERT_EQ(lines.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    for (std::size_t i = 0; i < lines[j].x.size(); ++i) {
      EXPECT_NEAR(lines[j].y[i], -stiffness[j] * (lines[j].x[i] - 1.0), 1e2 * roundOff);
    }
  }
}

TEST(FigureHookesLaw3D, DrawsTheForceAlongTheSpringOneMetreFor125Newton) {
  const Figure figure = draw("hookes_law_3d");
  const std::vector<Series> arrows = curvesOf(figure.panels().at(0), Pen::Arrows);
  ASSERT_EQ(arrows.size(), 2u);
  for (const Series& some : arrows) {
    ASSERT_EQ(some.x.size(), 16u);
    for (std::size_t i = 0; i < some.x.size(); ++i) {
      const auto [fx, fz] = hooke(some.x[i], some.y[i], 0.0, 0.0, 100.0, 1.0);
      EXPECT_NEAR(125.0 * some.dx[i], fx, 1e2 * roundOff);
      EXPECT_NEAR(125.0 * some.dy[i], fz, 1e2 * roundOff);
    }
  }
  for (const Series& points : curvesOf(figure.panels().at(1), Pen::Points)) {
    for (std::size_t i = 0; i < points.x.size(); ++i) {
      EXPECT_NEAR(points.y[i], -100.0 * (points.x[i] - 1.0), 1e2 * roundOff);
    }
  }
}

TEST(FigureTriangleForces, AreHookesAndTheirSumsClose) {
  const Figure figure = draw("triangle_forces");
  const double x[] = {0.0, 1.6, 0.55}, z[] = {0.0, 0.1, 1.2};
  const Series chain = curvesOf(figure.panels().at(1), Pen::Arrows).at(0);
  double tipX = 0.0, tipZ = 0.0;
  for (std::size_t node = 0; node < 3; ++node) {
    const std::size_t next = (node + 1) % 3, last = (node + 2) % 3;
    const auto [ax, az] = hooke(x[node], z[node], x[next], z[next], 50.0, 0.8);
    const auto [bx, bz] = hooke(x[node], z[node], x[last], z[last], 50.0, 0.8);
    EXPECT_NEAR(chain.dx[node], ax + bx, 1e2 * roundOff);
    EXPECT_NEAR(chain.dy[node], az + bz, 1e2 * roundOff);
    tipX += chain.dx[node];
    tipZ += chain.dy[node];
  }
  EXPECT_NEAR(std::hypot(tipX, tipZ), 0.0, 1e2 * roundOff);
}

TEST(FigureEnergyLandscape, IsHalfKTimesTheStretchSquaredWithRoundLines) {
  const Figure figure = draw("energy_landscape");
  const Panel& plane = figure.panels().at(0);
  const Field& field = plane.field.value();
  for (std::size_t j = 0; j < field.y.size(); ++j) {
    for (std::size_t i = 0; i < field.x.size(); ++i) {
      const double stretch = std::hypot(field.x[i], field.y[j]) - 1.0;
      ASSERT_NEAR(field.values[j * field.x.size() + i], 50.0 * stretch * stretch, 1e3 * roundOff);
    }
  }
  EXPECT_EQ(field.range.value(), std::pair(0.0, 50.0));
  const std::vector<Series> lines = curvesOf(plane, Pen::Structure);
  ASSERT_EQ(lines.size(), 4u);
  for (std::size_t j = 0; j < 4; ++j) {
    const double stretch = std::sqrt(2.0 * 10.0 * static_cast<double>(j + 1) / 100.0);
    for (std::size_t i = 0; i < lines[j].x.size(); ++i) {
      if (std::isnan(lines[j].x[i])) continue;
      const double r = std::hypot(lines[j].x[i], lines[j].y[i]);
      // Straight between places h = 0.02 m apart: h^2/8 E''/E', with E'' <= k (1 + stretch / r) and E' = k stretch.
      const double off = 0.02 * 0.02 / 8.0 * (1.0 + stretch / r) / stretch;
      EXPECT_NEAR(std::abs(r - 1.0), stretch, 1.5 * off);
    }
  }
}

TEST(FigureGradientField, ShowsTheForcesOfTwoSpringsAndTheSlopesOfTheirEnergy) {
  const Figure figure = draw("gradient_field");
  const auto force = [](double x, double z) {
    const auto [ax, az] = hooke(x, z, 0.0, -1.0, 100.0, 1.25);
    const auto [bx, bz] = hooke(x, z, 0.0, 1.0, 100.0, 1.25);
    return std::pair(ax + bx, az + bz);
  };
  const Series arrows = curvesOf(figure.panels().at(0), Pen::Arrows).at(0);
  ASSERT_EQ(arrows.x.size(), 35u);
  for (std::size_t i = 0; i < arrows.x.size(); ++i) {
    const auto [fx, fz] = force(arrows.x[i], arrows.y[i]);
    EXPECT_NEAR(400.0 * arrows.dx[i], fx, 1e3 * roundOff);
    EXPECT_NEAR(400.0 * arrows.dy[i], fz, 1e3 * roundOff);
  }
  const Series rests = curvesOf(figure.panels().at(0), Pen::Points).at(0);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(force(rests.x[i], rests.y[i]).first, 0.0, 1e2 * roundOff);
  const std::vector<Series> lines = curvesOf(figure.panels().at(1), Pen::Line);
  for (std::size_t i = 0; i < lines.at(0).x.size(); ++i) {
    EXPECT_NEAR(lines[0].y[i], force(lines[0].x[i], 0.3).first, 1e3 * roundOff);
    EXPECT_NEAR(lines.at(1).y[i], force(lines[0].x[i], 0.3).second, 1e3 * roundOff);
  }
  // Central differences 1e-4 m apart: 1e-8/6 E''' (E''' of some 1e3 N/m^2), and round-off of 50 J * 1e-16 / 1e-4 m.
  const std::vector<Series> slopes = curvesOf(figure.panels().at(1), Pen::Points);
  for (std::size_t i = 0; i < slopes.at(0).x.size(); ++i) {
    EXPECT_NEAR(slopes[0].y[i], force(slopes[0].x[i], 0.3).first, 1e-5);
    EXPECT_NEAR(slopes.at(1).y[i], force(slopes[0].x[i], 0.3).second, 1e-5);
  }
}

TEST(FigureProjectedDamping, KeepsTheAngularMomentumAndTakesTheVibrationAtTheRateOfDOverMu) {
  const Figure figure = draw("projected_damping");
  // mu = 3/4 kg, 1.2 m apart, 4.8 m/s relative.
  const double J = 0.75 * 1.2 * 4.8;
  const double turning = curvesOf(figure.panels().at(0), Pen::Reference).at(0).y.front();
  EXPECT_NEAR(252.0 * (turning - 1.0), J * J / (0.75 * std::pow(turning, 3)), 1e3 * roundOff);
  const std::vector<Series> kept = curvesOf(figure.panels().at(1), Pen::Line);
  // The only change of J is the method's: (omega h)^5 / 120 a turn of omega h = 4e-3, over 2000 steps.
  for (const double ratio : kept.at(0).y) EXPECT_NEAR(ratio, 1.0, 1e-9);
  const Series& energy = kept.at(1);
  EXPECT_EQ(energy.y.front(), 1.0);
  EXPECT_TRUE(std::is_sorted(energy.y.rbegin(), energy.y.rend()));
  // A damped oscillator of mass mu loses E as exp(-d t / mu), up to d / (mu omega) = 4 / 20 by phase.
  for (const double t : {0.5, 1.0, 2.0}) EXPECT_NEAR(valueAt(energy, t) / std::exp(-4.0 * t), 1.0, 0.2);
}

TEST(FigurePropertyMeanHeight, SwingsAtItsFrequencyAndMovesEachPupilAsFarWithDrag) {
  const Figure figure = draw("property_mean_height");
  const double omega = std::sqrt(8000.0 / 25.0 * (1.0 / 70 + 1.0 / 30 + 1.0 / 55 + 1.0 / 40 + 1.0 / 90));
  const Series mean = curvesOf(figure.panels().at(0), Pen::Points).at(0);
  ASSERT_EQ(mean.x.size(), 31u);
  for (std::size_t i = 0; i < mean.x.size(); ++i) {
    // Runge-Kutta: phase (omega h)^5 / 120 a step = 5e-9, over 300 steps, times 0.4 m.
    EXPECT_NEAR(mean.y[i], 2.0 - 0.4 * std::cos(omega * mean.x[i]), 1e-6);
  }
  // With the same drag on all, d times the way is the impulse, which is the same for all: 0.4 m, the mean's way. What
  // is left decays at d / 2m = 0.55 /s at the least (90 kg): 1.2 % of 0.4 m after 8 s.
  const std::vector<Series> pupils = curvesOf(figure.panels().at(1), Pen::Line);
  ASSERT_EQ(pupils.size(), 6u);
  const double starts[] = {1.3, 1.4, 1.5, 1.8, 2.0, 1.6};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(pupils[i].y.front(), i < 5 ? starts[i] : pupils[i].y.front());
    EXPECT_NEAR(pupils[i].y.back(), starts[i] + 0.4, 0.005);
  }
}

TEST(FigureBounce, ComesBackToItsHeightAtAFineStepAndIsThrownBeyondTheLimit) {
  const Figure figure = draw("bounce");
  const std::vector<Series> flights = curvesOf(figure.panels().at(0), Pen::Line);
  ASSERT_EQ(flights.size(), 4u);
  const double fall = std::sqrt(2.0 / g), omega = std::sqrt(1e5);
  const Series& fine = flights[0];
  // The contact is half a swing of the floor, pi / omega, and 2 g / (omega^2 v) = 4e-5 s more for the weight. Velocity
  // Verlet moves its end by (omega h)^2 / 24 of 10 ms, 4e-5 s. Both, times at most 3 m/s, stay below a third of 1 mm.
  const double again = 2.0 * fall + std::numbers::pi / omega;
  const auto heightAt = [&](double t) { return 1.0 - 0.5 * g * t * t; };
  EXPECT_NEAR(valueAt(fine, 0.4), heightAt(0.4), 1e-6);
  for (const double t : {0.7, 1.0, 1.2}) EXPECT_NEAR(valueAt(fine, t), heightAt(t - again), 1e-3) << t;
  // 1/240 s is within 2 / omega = 6.3 ms: off, but not thrown. 1/60 s is beyond it, the touch located or not.
  EXPECT_LT(*std::max_element(flights[1].y.begin(), flights[1].y.end()), 1.2);
  for (const std::size_t j : {2u, 3u}) EXPECT_GT(*std::max_element(flights[j].y.begin(), flights[j].y.end()), 50.0);
  EXPECT_NE(figure.title().find("6.3 ms"), std::string::npos);
}

/// Elastic energy [J] of the two springs across their axis.
double bucklingEnergy(double y) { return 100.0 * std::pow(std::hypot(0.8, y) - 1.0, 2); }

TEST(FigureBuckling, RestsAt60CentimetresAndLeavesTheSaddleTwice) {
  const Figure figure = draw("buckling");
  const Panel& landscape = figure.panels().at(0);
  const Series curve = curvesOf(landscape, Pen::Line).at(0);
  for (std::size_t i = 0; i < curve.x.size(); ++i) {
    EXPECT_NEAR(curve.y[i], bucklingEnergy(curve.x[i]), 1e2 * roundOff);
  }
  const Series stable = curvesOf(landscape, Pen::Points).at(0), saddle = curvesOf(landscape, Pen::Points).at(1);
  // Both springs at their length, found to a residual below 1e-7 N over a stiffness of 72 N/m.
  EXPECT_NEAR(stable.x.at(0), -0.6, 1e-8);
  EXPECT_NEAR(stable.x.at(1), 0.6, 1e-8);
  EXPECT_NEAR(saddle.x.at(0), 0.0, 1e-12);
  EXPECT_NEAR(saddle.y.at(0), 4.0, 1e-12);

  // Without drag from y0 = 1 mm to y1, where the energy is that again, and back: T = 2 int dy / sqrt(2 (E0 - E)), with
  // y = y0 + (y1 - y0) sin^2(s), whose integrand is smooth (E' does not vanish at the ends).
  const double y0 = 1e-3, E0 = bucklingEnergy(y0);
  const double y1 = std::sqrt(std::pow(2.0 - std::hypot(0.8, y0), 2) - 0.64);
  double period = 0.0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double s = 0.5 * std::numbers::pi * (i + 0.5) / n;
    const double y = y0 + (y1 - y0) * std::pow(std::sin(s), 2);
    period += 2.0 * (y1 - y0) * 2.0 * std::sin(s) * std::cos(s) / std::sqrt(2.0 * (E0 - bucklingEnergy(y))) * 0.5 *
              std::numbers::pi / n;
  }
  const Series free = curvesOf(figure.panels().at(2), Pen::Line).at(0);
  const auto middle = free.y.begin() + static_cast<std::ptrdiff_t>(std::lround(period / 0.01));
  const auto first = std::max_element(free.y.begin(), middle), second = std::max_element(middle, free.y.end());
  const auto timeOf = [&](auto peak) { return free.x[static_cast<std::size_t>(peak - free.y.begin())]; };
  // Outputs are 10 ms apart: a peak is met to 5 ms, and to 1/2 y'' (5 ms)^2 with y'' = 200 * 0.2 * 0.9 / 1.2 = 30
  // m/s^2.
  EXPECT_NEAR(timeOf(first), 0.5 * period, 6e-3);
  EXPECT_NEAR(timeOf(second), 1.5 * period, 6e-3);
  for (const auto& peak : {first, second}) EXPECT_NEAR(*peak, y1, 5e-4);
  EXPECT_NEAR(curvesOf(figure.panels().at(2), Pen::Line).at(1).y.back(), 0.6, 5e-3);  // with drag: exp(-1.5 * 4)
}

TEST(FigureAreaVolumeSprings, HasTwoWellsForSpringsAndOneForAStiffSign) {
  const Figure figure = draw("area_volume_springs");
  const double A0 = 0.75, V0 = 0.25 * std::sqrt(3.0) * std::pow(0.75 * std::sqrt(3.0), 2) / 3.0;
  const double size[] = {A0, V0}, stiffness[2][3] = {{0.0, 3.0, 10.0}, {0.0, 20.0, 100.0}}, barrier[] = {2.5, 3.75};
  for (std::size_t panel = 0; panel < 2; ++panel) {
    const std::vector<Series> curves = curvesOf(figure.panels().at(panel), Pen::Line);
    ASSERT_EQ(curves.size(), 3u);
    for (std::size_t j = 0; j < 3; ++j) {
      const double k = stiffness[panel][j], whole = 0.5 * k * size[panel] * size[panel];
      EXPECT_NEAR(valueAt(curves[j], 1.0), 0.0, roundOff);
      EXPECT_NEAR(valueAt(curves[j], 0.0), barrier[panel] + whole, 10.0 * roundOff);
      EXPECT_NEAR(valueAt(curves[j], -1.0), 4.0 * whole, 10.0 * roundOff);
      const bool hasWell = std::is_sorted(curves[j].y.begin(), curves[j].y.begin() + 200, std::greater<>()) == false;
      EXPECT_EQ(hasWell, j < 2);
    }
  }
}

TEST(FigureDampingRegimes, FollowTheThreeClosedForms) {
  const Figure figure = draw("damping_regimes");
  const std::vector<Series> curves = curvesOf(figure.panels().at(0), Pen::Line);
  ASSERT_EQ(curves.size(), 3u);
  const double beat = std::sqrt(99.0), slow = 100.0 - std::sqrt(9900.0), fast = 100.0 + std::sqrt(9900.0);
  for (std::size_t i = 0; i < curves[0].x.size(); ++i) {
    const double t = curves[0].x[i];
    // Runge-Kutta's (lambda h)^5 / 120 a step: 1e-12 where omega h = 0.01; 3e-6 of the fast part where lambda h = 0.2,
    // which is gone after 25 steps and starts at slow / fast = 0.25 %.
    EXPECT_NEAR(curves[0].y[i], std::exp(-t) * (std::cos(beat * t) + std::sin(beat * t) / beat), 1e-8);
    EXPECT_NEAR(curves[1].y[i], (1.0 + 10.0 * t) * std::exp(-10.0 * t), 1e-8);
    EXPECT_NEAR(curves[2].y[i], (fast * std::exp(-slow * t) - slow * std::exp(-fast * t)) / (fast - slow), 1e-6);
  }
}

TEST(FigurePenaltyDepth, IsTheWeightOverTheStiffness) {
  const Figure figure = draw("penalty_depth");
  const Series depth = curvesOf(figure.panels().at(0), Pen::Points).at(0);
  ASSERT_EQ(depth.x.size(), 9u);
  // The floor is linear: one step of Newton, to round-off.
  for (std::size_t i = 0; i < depth.x.size(); ++i) EXPECT_NEAR(depth.y[i] * depth.x[i], g, 1e-9);
}

TEST(FigureFrictionThreshold, HoldsUpToTheAngleAndSlidesAsTheExcessBeyond) {
  const Figure figure = draw("friction_threshold");
  const Series slid = curvesOf(figure.panels().at(0), Pen::Line).at(0);
  for (std::size_t i = 0; i < slid.x.size(); ++i) {
    const double angle = slid.x[i] * std::numbers::pi / 180.0;
    const double excess = g * (std::sin(angle) - 0.5 * std::cos(angle));
    // The friction anchor gives way elastically first: mu m g / k = 0.5 mm.
    EXPECT_NEAR(slid.y[i], excess > 0.0 ? 0.5 * excess * 4.0 : 0.0, 2e-3) << slid.x[i];
  }
}

TEST(FigureNumericalDamping, IsBackwardEulersRecurrence) {
  const Figure figure = draw("numerical_damping");
  const std::vector<Series> curves = curvesOf(figure.panels().at(0), Pen::Line);
  const double perSecond[] = {60.0, 240.0, 960.0};
  ASSERT_EQ(curves.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    // x - i v / omega is divided by 1 - i omega h each step.
    const double w = 2.0 * std::numbers::pi / perSecond[j];
    for (std::size_t i = 0; i < curves[j].x.size(); ++i) {
      const double n = std::round(curves[j].x[i] * perSecond[j]);
      // 5760 steps, each solved to a relative 1e-10 or better.
      EXPECT_NEAR(curves[j].y[i], std::pow(1.0 + w * w, -0.5 * n) * std::cos(n * std::atan(w)), 1e-7);
    }
  }
}

TEST(FigureGatherScatter, CountsEachSpringTwiceAndOnce) {
  const Figure figure = draw("gather_scatter");
  const std::vector<Series> curves = curvesOf(figure.panels().at(2), Pen::LinePoints);
  for (std::size_t i = 0; i < curves.at(0).x.size(); ++i) {
    const double n = std::sqrt(curves[0].x[i]);
    const double springs = 2.0 * n * (n - 1.0) + 2.0 * (n - 1.0) * (n - 1.0);  // sides and diagonals
    EXPECT_EQ(curves[0].y[i], 2.0 * springs);
    EXPECT_EQ(curves.at(1).y[i], springs);
  }
}

}  // namespace
}  // namespace muelle::plots
