#pragma once
#include "engine/scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>

namespace muelle::lab {

/// What a run will take, told from the scene before anything of it is built. The memory is what it takes at least: a
/// run that would fit is never refused.
struct Foresight {
  std::optional<double> steps;    ///< nothing where a tolerance chooses them
  std::optional<double> outputs;  ///< nothing where every one of those steps is an output
  double unknowns = 0.0;
  double output = 0.0;    ///< one recorded output [byte]
  double model = 0.0;     ///< nodes, springs and so on, and the system that is built of them [byte]
  double state = 0.0;     ///< what the method keeps: states, forces, stages [byte]
  double matrices = 0.0;  ///< of an implicit method: stiffness, damping, and the factors of their sum [byte]

  double look = 0.0;  ///< at the step before the run, gone when outputs come: vectors about the fastest modes [byte]

  /// Without outputs [byte].
  double system() const { return model + state + matrices; }
  /// How many outputs are kept where they may take `room` bytes: beyond it they are thinned, but not below 1000.
  double kept(double room) const;
  /// All of it, with as few outputs as thinning can leave [byte].
  double least() const { return system() + kept(0.0) * output; }
  /// What the run itself will take at its height, where outputs may take `room` bytes [byte]: within 1.5 of it for
  /// scenes of 10^4 nodes and more. The runs for the error come later, and take about as much as this one's outputs.
  double peak(double room) const;
  /// Whether one waits for it: more than some seconds, or a quarter of a GiB. \param room as for peak()
  bool isLong(double room) const;
};
Foresight foresee(const engine::Scene& scene);

/// "foreseen: about 10,000 steps, 101 outputs, 35.2 MiB".
std::string foreseenText(const Foresight& foresight, double room);

/// What this process can still take [byte]: MemAvailable of the system, less where the process has a limit of its own;
/// infinite where the system does not tell. \param meminfo the file that tells
double availableMemory(const std::filesystem::path& meminfo = "/proc/meminfo");

/// What the recorded outputs may take where so much memory is there [byte]: a quarter of what the system leaves (the
/// runs for the error and a table are as large), at most the engine's own bound.
double roomForOutputs(const Foresight& foresight, double available);

/// Throws std::invalid_argument, one line with both numbers, what takes most and what to change, when the run needs
/// more memory than is there [byte].
void requireMemory(const engine::Scene& scene, const Foresight& foresight, double available);

}  // namespace muelle::lab
