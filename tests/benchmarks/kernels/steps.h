#pragma once
#include "cloth.h"
#include "plain_loop.h"

#include <memory>

namespace muelle::benchmarks {

/// Steps of symplectic Euler as one would write them: the plain loop over springs, then a loop over nodes. Two corners
/// of the cloth are held.
class PlainSteps {
 public:
  PlainSteps(const Cloth& cloth, bool damped, const PlainLoops& loops);
  void step();

 private:
  PlainLoops loops_;
  bool damped_;
  std::vector<PlainSpring> springs_;
  std::vector<PlainDampedSpring> dampedSprings_;
  std::vector<double> x_, v_, f_;
  std::vector<bool> held_;
};

/// The same steps of the engine: the model is built, and a simulation takes them with all its checks.
class EngineSteps {
 public:
  explicit EngineSteps(const Cloth& cloth);
  ~EngineSteps();
  void step();

 private:
  struct Run;
  std::unique_ptr<Run> run_;
};

}  // namespace muelle::benchmarks
