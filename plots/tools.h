#pragma once
#include "engine/control/simulate.h"
#include "engine/model/model_system.h"
#include "figure_list.h"

#include <string>
#include <string_view>
#include <vector>

namespace muelle::plots {

/// n numbers from `low` to `high`, both included, at equal distances; n >= 2.
std::vector<double> linear(double low, double high, int n);
/// n numbers from `low` to `high`, both included, at equal ratios; n >= 2, low > 0.
std::vector<double> logarithmic(double low, double high, int n);

/// One digit and the power of ten, as it is written by hand: 3·10⁻⁹.
std::string asPower(double value);

/// A node of mass m [kg] in 1D at x0 [m], on a spring k [N/m] of rest length 0 to the origin, with node drag d [kg/s].
engine::Model oscillator(double m, double k, double x0, double d = 0.0);

/// Hard case H04, regular: an elastic pendulum in the x-z plane, k = 100 N/m and 1 kg, released at (0.3, -1) m.
engine::Model elasticPendulum();

/// Runs a built model from its initial state, without the warnings' pilot runs. A step h [s] is fixed.
engine::RunResult run(const engine::ModelSystem& system, std::string_view method, double h, double duration,
                      double outputInterval = 0.0);

/// One number for each output: measure(state).
std::vector<double> along(const Trajectory& trajectory, const std::function<double(const State&)>& measure);

}  // namespace muelle::plots
