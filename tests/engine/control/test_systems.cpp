#include "test_systems.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::engine::testing {

void PenaltyBalls::force(double, In x, In v, In z, Out f) const {
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double contactForce = contact(x[i], v[i]);
    const double live = x[i] < 0.0 ? std::max(0.0, contactForce) : 0.0;
    f[i] = -mass_[i] * g_ + (z[i] == 0.0 ? live : z[i] == 2.0 ? contactForce : 0.0);
  }
}

std::string PenaltyBalls::unknownName(int i) const { return fmt::format("ball {}", i); }

void PenaltyBalls::guards(double, In x, In v, In z, Out g) const {
  for (std::size_t i = 0; i < x.size(); ++i) g[i] = z[i] == 2.0 ? contact(x[i], v[i]) : x[i];
}

std::string PenaltyBalls::guardName(int i) const { return fmt::format("ball {} touches or leaves the plane", i); }

bool PenaltyBalls::commit(State& state, bool frozen) const {
  const std::vector<double> before = state.z;
  for (std::size_t i = 0; i < state.z.size(); ++i) {
    if (!frozen) {
      state.z[i] = 0.0;
    } else if (state.z[i] == 0.0) {
      state.z[i] = state.x[i] < 0.0 && contact(state.x[i], state.v[i]) > 0.0 ? 2.0 : 1.0;
    }
  }
  return state.z != before;
}

void PenaltyBalls::cross(int guard, State& state) const {
  double& mode = state.z[static_cast<std::size_t>(guard)];
  const double v = state.v[static_cast<std::size_t>(guard)];
  if (mode == 2.0) {
    mode = 1.0;
  } else if (v < 0.0) {  // the height falls through 0; on the way up after an early release nothing happens
    mode = 2.0;
  }
}

double PenaltyBalls::sweptBound(double, In x, In v, In, double h) const {
  double bound = h;
  for (std::size_t i = 0; i < x.size() && thickness > 0.0; ++i) {
    // Travel |v| h + |a| h^2 / 2 of at most a twentieth of the plate (or half the way to it) while it is in reach.
    const double a = x[i] < 0.0 ? k_ * std::abs(x[i]) / mass_[i] + g_ : g_;
    const double reach = std::max(0.05 * thickness, 0.5 * x[i]);
    if (x[i] - std::abs(v[i]) * h > thickness) continue;
    bound = std::min(bound, 2.0 * reach / (std::abs(v[i]) + std::sqrt(v[i] * v[i] + 2.0 * a * reach)));
  }
  return bound;
}

void PulsedMass::force(double t, In, In, In z, Out f) const {
  f[0] = force_(t, z[0] < 0.0 ? segment(t) : static_cast<int>(z[0]));
}

int PulsedMass::segment(double t) const {
  return static_cast<int>(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
}

void PulsedMass::declaredTimes(double from, double to, std::vector<double>& times) const {
  for (const double t : times_) {
    if (t > from && t <= to) times.push_back(t);
  }
}

bool PulsedMass::commit(State& state, bool frozen) const {
  const double before = state.z[0];
  state.z[0] = frozen ? segment(state.t) : -1.0;
  return state.z[0] != before;
}

}  // namespace muelle::engine::testing
