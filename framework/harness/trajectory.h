#pragma once
#include "harness/state.h"

#include <filesystem>
#include <string>
#include <vector>

namespace muelle {

/// A number measured along a run: its name, unit and one value per output time.
struct Track {
  std::string name;  ///< "kinetic energy"
  std::string unit;  ///< "J"
  std::vector<double> values;
};

/// Why a run ended before its time.
struct StopReport {
  bool stopped = false;
  double t = 0.0;       ///< time at which the fault shows first [s]
  int unknown = -1;     ///< first degree of freedom that is not finite (in an explosion: the fastest), or -1
  std::string message;  ///< one line: time, node, what
};

/// What a simulation leaves: the states at the output times, and what the probes measured there.
struct Trajectory {
  std::vector<double> t;               ///< output times [s]
  std::vector<std::vector<double>> x;  ///< positions [m], one flat array per output time
  std::vector<std::vector<double>> v;  ///< velocities [m/s]
  std::vector<Track> tracks;           ///< in the order of the probes
  StopReport stop;

  /// One coordinate over time: unknown i of x (of v).
  std::vector<double> position(int i) const;
  std::vector<double> velocity(int i) const;
  /// Values of the probe of that name; throws std::out_of_range naming the probes there are.
  const std::vector<double>& track(const std::string& name) const;
  /// The last recorded state (x, v, t).
  State last() const;
};

/// Writes t, positions, velocities and the tracks as columns, under a line of heads by node and axis with their units:
/// "node 12 z [m]", "node 12 vz [m/s]". `axes` names the components of a node in the order of the flat arrays: "x",
/// "xz", "xyz". Throws std::invalid_argument when they do not divide the arrays, std::runtime_error when the file
/// cannot be written; leaves no half-written file.
void writeCsv(const Trajectory& trajectory, const std::string& axes, const std::filesystem::path& file);

}  // namespace muelle
