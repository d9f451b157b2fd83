#pragma once
#include "lab/bench/curve.h"

#include <filesystem>
#include <vector>

namespace muelle::bench {

/// A curve as it stands in a kept points.csv; of its times only the statistics are there.
struct KeptCurve {
  std::string key;            ///< "ours:muelle:velocity_verlet"
  std::vector<double> error;  ///< e_x; infinite where the run failed
  std::vector<double> evaluations;
  std::vector<Statistics> seconds;
};

/// The curves of a scene in points.csv. Throws std::runtime_error with the file's name when it cannot be read or holds
/// none of the scene.
std::vector<KeptCurve> readKeptCurves(const std::filesystem::path& file, const std::string& scene);

/// The points.csv in the folders of `results`, the first by name: results of one machine are one folder. Throws
/// std::runtime_error when there is none.
std::filesystem::path keptPoints(const std::filesystem::path& results);

}  // namespace muelle::bench
