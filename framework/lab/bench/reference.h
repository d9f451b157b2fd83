#pragma once
#include "engine/model/model_system.h"
#include "lab/bench/contestant.h"
#include "lab/bench/scene.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle::bench {

/// Errors over a whole run, in parts of the motion (lab/run/run_scene.h, ErrorEstimate): the largest difference of a
/// node at any time that was looked at, over the largest y(t) = x(t) - x(0) - V t of a node; likewise of v - V.
struct PathError {
  double position = 0.0;  ///< e_x, on which the bars are read
  double velocity = 0.0;  ///< e_v
};

/// The largest distance of a node between two arrays of `dimension` numbers a node.
double largestNodeDistance(const std::vector<double>& a, const std::vector<double>& b, int dimension);

/// What a scene's exact solution is taken to be: states at equal times from DOP853 at a tolerance of 1e-13 (1e-11 from
/// 100 unknowns on), held against a peer's run.
///
/// A run is compared at the ends of its own steps: the reference goes there from its last state before, so that no
/// method is charged with an interpolation between its steps. `scene` and `system` must outlive it.
class Reference {
 public:
  /// Computes the states, or reads those that an earlier call has left in `file` for the same program (`stamp`).
  Reference(const BenchScene& scene, const engine::ModelSystem& system, const std::filesystem::path& file,
            const std::string& stamp);

  /// Throws std::runtime_error on a path without points.
  PathError errorOf(const Path& path) const;

  /// Sets doubt(): the error of an arbiter's run, a method of another library at its best.
  void judgeBy(const std::string& arbiter, const PathError& error);
  const PathError& doubt() const { return doubt_; }
  const std::string& arbiter() const { return arbiter_; }
  /// The scene's largest |y| [m] and |v - V| [m/s] of a node, at any end of a step of the reference.
  const PathError& motion() const { return motion_; }

  /// How much an offset of the start grows: the largest e_x at any sample over that with which the start was disturbed
  /// (each node by 1e-7 of the motion, in directions drawn at random).
  double amplification() const;

 private:
  void compute();
  bool read(const std::filesystem::path& file, const std::string& stamp);
  void write(const std::filesystem::path& file, const std::string& stamp) const;
  std::vector<State> statesFrom(State start, double tolerance, PathError* motion) const;
  State stateAt(double t) const;

  const BenchScene& scene_;
  const engine::ModelSystem& system_;
  std::vector<State> states_;  ///< at sample 0, 1, ...
  PathError motion_, doubt_;
  std::string arbiter_;
};

}  // namespace muelle::bench
