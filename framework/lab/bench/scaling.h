#pragma once
#include "lab/bench/bars.h"
#include "lab/bench/statistics.h"
#include "lab/bench/stopwatch.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle::bench {

struct ScalingOptions {
  double mostSprings = 1e7;   ///< of explicit methods
  double longestStep = 20.0;  ///< [s] an implicit method goes to no larger scene once a step takes a tenth of it
  double leastTimed = 0.2;    ///< [s] of each time
  int rounds = 7;
  Clock now = processorTime;
  std::function<void(double fraction)> progress = [](double) {};
};

/// A scene's size against what it takes.
struct ScalingRow {
  std::string kind;  ///< "grid", "general", "bdf2", "files"
  long long springs = 0, unknowns = 0;
  Statistics step;                 ///< [s] of a step
  double bytes = 0.0;              ///< that building has taken of the memory, the model aside
  double build = 0.0;              ///< [s]
  double read = 0.0, write = 0.0;  ///< [s] of the scene file, and of a table of all nodes at one time; of "files"
};

struct Scaling {
  std::vector<ScalingRow> rows;
  Statistics meanHeightStep, copying;  ///< [s] an implicit step of 1e5 uncoupled nodes, and copying their x and v
  std::vector<std::string> notes;      ///< sizes that were left out, and why
};

/// Velocity Verlet on cloth in order ("grid") and in random order ("general") from 1e3 springs on by factors of ten;
/// backward Euler and BDF2 on cloth up to what memory and time hold; reading, building and writing of scene files; an
/// implicit step of hard case H05.
Scaling measureScaling(const ScalingOptions& options);

std::string scalingText(const Scaling& scaling);
std::string scalingCsv(const Scaling& scaling);
/// A section of the page.
std::string scalingSection(const Scaling& scaling);
std::vector<Bar> barsOf(const Scaling& scaling);

}  // namespace muelle::bench
