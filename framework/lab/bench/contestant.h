#pragma once
#include "lab/bench/path.h"

#include <memory>
#include <string>
#include <vector>

namespace muelle::bench {

/// Which row of a comparison a curve belongs to.
enum class Row {
  Ours,    ///< the engine's method on the engine's force
  Plain,   ///< A: a peer on a plain loop over the springs, as its user writes it
  Kernel,  ///< B: a peer on the engine's force
};

/// "ours", "A", "B".
std::string nameOf(Row row);
/// Throws std::invalid_argument for another word.
Row rowOf(const std::string& name);

/// What a run has cost besides time; counted by the right-hand side itself, not by what a library says of it.
struct RunCost {
  long long evaluations = 0;  ///< of the force of the whole scene
  long long jacobians = 0;    ///< matrices assembled
  long long solves = 0;       ///< of linear systems
  std::string failure;        ///< one line: why the run did not reach its end; empty when it did
};

/// A method of some library on a scene: what one curve of the plane is made of.
class Contestant {
 public:
  virtual ~Contestant() = default;

  virtual Row row() const = 0;
  virtual std::string library() const = 0;  ///< "muelle", "odeint"
  virtual std::string method() const = 0;   ///< "velocity_verlet", "dopri5"
  /// Whether run()'s setting is a tolerance; else it is a step [s].
  virtual bool takesTolerance() const = 0;
  /// Whether it finds the times of contacts; else it steps across them.
  virtual bool locatesEvents() const { return false; }

  /// Whether its runs at the tightest tolerances may be the second source of a reference.
  virtual bool mayJudge() const { return false; }

  /// Solves the scene from its start to its end. What is allocated and prepared counts as a part of the run, as it does
  /// for whoever runs a scene once; building the scene does not.
  /// \param setting  the tolerance, or the step [s], made shorter to what BenchScene::stepsOf() says
  /// \param path     shown the ends of the steps; null in a run that is timed
  virtual RunCost run(double setting, Path* path) = 0;

  /// What tells it from the others of a scene, without spaces or commas: "A:odeint:dopri5".
  std::string key() const { return nameOf(row()) + ":" + library() + ":" + method(); }
};

/// key() of the loop that a beginner writes, on which bars are read.
inline constexpr const char* naiveEulerKey = "A:plain:symplectic_euler";

using Contestants = std::vector<std::unique_ptr<Contestant>>;

}  // namespace muelle::bench
