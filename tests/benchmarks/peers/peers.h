#pragma once
#include "engine/model/model_system.h"
#include "lab/bench/contestant.h"
#include "lab/bench/scene.h"

#include <memory>

namespace muelle::bench {

/// The methods of other libraries that can run a scene, each on a plain loop over the springs (row A) and on the
/// engine's force (row B). It holds the problems that the contestants refer to.
class Peers {
 public:
  /// `scene` and `system` must outlive it.
  Peers(const BenchScene& scene, const engine::ModelSystem& system);
  ~Peers();
  Peers(const Peers&) = delete;
  Peers& operator=(const Peers&) = delete;

  /// Names and versions of the libraries: "Boost 1.74".
  static std::vector<std::string> versions();

  /// Appends them to `all`.
  void addTo(Contestants& all) const;

 private:
  struct Problems;
  const BenchScene& scene_;
  std::unique_ptr<Problems> problems_;
};

}  // namespace muelle::bench
