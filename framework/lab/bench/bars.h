#pragma once
#include "lab/bench/plane.h"

#include <string>
#include <vector>

namespace muelle::bench {

/// What was promised of a speed, and what came out.
struct Bar {
  enum class Verdict { Met, Missed, NotMeasured };
  std::string where;     ///< "pendulum, 1e-04"
  std::string promise;   ///< "at least 1.5 times as fast as the best of A"
  std::string measured;  ///< "1.02 (0.98 to 1.07): ours nystrom8, A odeint sb3a"
  Verdict verdict = Verdict::NotMeasured;
};

std::string nameOf(Bar::Verdict verdict);

/// The bars of a scene: every entry of the plane against A and B, and where it has one that of the naive loop.
std::vector<Bar> barsOf(const SceneResult& scene);

/// "12 of 40 bars met, 3 not measured".
std::string countOf(const std::vector<Bar>& bars);

}  // namespace muelle::bench
