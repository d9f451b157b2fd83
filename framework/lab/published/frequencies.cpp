#include "lab/published/models.h"
#include "lab/published/problem.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::published {

namespace {

Problem instrument() {
  const double m = 2.5 / 386.0;
  return {
      "VM45",
      "A mass on a spring",
      "Ansys Mechanical APDL Verification Manual, VM45; W. T. Thomson, Vibration Theory and Applications (1965), p. 6, "
      "ex. 1.2-2",
      "k = 48 lb/in, W = 2.5 lb, g = 386 in/s^2",
      "",
      {{"f", "Hz", "13.701", std::sqrt(48.0 / m) / (2.0 * pi)}},
      [m] {
        return frequenciesOf(row({m}, {{-1, 0, 48.0}}));
      }};
}

Problem twoMasses() {
  // 0.5 L^2 - 1500 L + 360000 = 0 for L = omega^2.
  const double root = std::sqrt(1500.0 * 1500.0 - 2.0 * 360000.0);
  const double w1 = std::sqrt(1500.0 - root);
  const double w2 = std::sqrt(1500.0 + root);
  return {
      "VM89",
      "Two masses between three springs",
      "Ansys Mechanical APDL Verification Manual, VM89 (Hz), and Ansys LS-DYNA Verification Manual, "
      "VM-LSDYNA-SOLVE-052 (rad/s, as in the book); Thomson (1965), p. 163, ex. 6.2-2",
      "m1 = 0.5, m2 = 1 lb s^2/in; k1 = k2 = 200, between the masses 800 lb/in",
      "",
      {{"f1", "Hz", "2.5814", w1 / (2.0 * pi)},
       {"f2", "Hz", "8.3263", w2 / (2.0 * pi)},
       {.what = "omega1", .unit = "rad/s", .printed = "16.25", .exact = w1, .printedIsOff = true},
       {.what = "omega2", .unit = "rad/s", .printed = "52.31", .exact = w2, .printedIsOff = true}},
      [] {
        const std::vector<double> f = frequenciesOf(row({0.5, 1.0}, {{-1, 0, 200.0}, {0, 1, 800.0}, {1, -2, 200.0}}));
        return std::vector<double>{f[0], f[1], 2.0 * pi * f[0], 2.0 * pi * f[1]};
      }};
}

Problem eightMasses() {
  std::vector<Quantity> quantities;
  const char* printed[] = {"5.5274", "10.8868", "15.9155", "20.4606", "24.3840", "27.5664", "29.9113", "31.3474"};
  for (int i = 1; i <= 8; ++i) {
    quantities.push_back({fmt::format("f{}", i), "Hz", printed[i - 1], 100.0 * std::sin(i * pi / 18.0) / pi});
  }
  return {"SDLD02",
          "Eight masses between nine springs",
          "Code_Aster, SDLD02 (V2.01.002), from the guide VPCS of the Societe Francaise des Mecaniciens",
          "m = 10 kg, k = 1e5 N/m, both ends held",
          "",
          quantities,
          [] {
            std::vector<RowSpring> springs = {{-1, 0, 1e5}, {7, -2, 1e5}};
            for (int i = 0; i < 7; ++i) springs.push_back({i, i + 1, 1e5});
            return frequenciesOf(row(std::vector<double>(8, 10.0), springs));
          }};
}

Problem dampedFrequency() {
  return {"V2.01.034",
          "A damped oscillator is let go",
          "Code_Aster, validation manual V2.01.034, case 2",
          "m = 1 kg, k = pi^2 N/m, c = 0.2 pi N s/m, x(0) = 1 m",
          "the frequency is that of the crossings of the middle along a run",
          {{"f", "Hz", "0.4975", 0.5 * std::sqrt(0.99)}},
          [] {
            Model model = row({1.0}, {{-1, 0, pi * pi, 0.2 * pi}});
            model.nodes[0].x[0] += 1.0;
            const double dt = 1e-3;
            const std::vector<Motion1D> motion = motionOf(model, 0, 6.0, dt, 0.01);
            std::vector<double> crossings;
            for (std::size_t i = 1; i < motion.size(); ++i) {
              const double before = motion[i - 1].x + 1.0;
              const double after = motion[i].x + 1.0;
              if (before * after >= 0.0) continue;
              // The cubic through both ends is what the motion is between them, to 1e-14: two steps of Newton on it.
              double s = before / (before - after);
              for (int k = 0; k < 3; ++k) {
                const double a = dt * motion[i - 1].v, b = dt * motion[i].v;
                const double h = s - 1.0;
                const double value =
                    before * (1.0 + 2.0 * s) * h * h + after * s * s * (3.0 - 2.0 * s) + a * s * h * h + b * s * s * h;
                const double slope = 6.0 * s * h * (before - after) + a * h * (3.0 * s - 1.0) + b * s * (3.0 * s - 2.0);
                s -= value / slope;
              }
              crossings.push_back(dt * (static_cast<double>(i - 1) + s));
            }
            return std::vector<double>{1.0 / (crossings.at(2) - crossings.at(0))};
          }};
}

}  // namespace

std::vector<Problem> frequencyProblems() { return {instrument(), twoMasses(), eightMasses(), dampedFrequency()}; }

}  // namespace muelle::published
