#pragma once
#include "lab/bench/sweep.h"

#include <optional>
#include <string>
#include <vector>

namespace muelle::bench {

/// The best of a row at an error.
struct Best {
  const Curve* curve = nullptr;
  Crossing crossing;
  Statistics seconds;        ///< over the rounds, at the very error (interpolated)
  double evaluations = 0.0;  ///< there
  bool better = false;       ///< its coarsest run that stands is better than asked
};

/// An entry of the table "best of ours, best A, best B, ratios".
struct Entry {
  double target = 0.0;
  bool allowed = true;  ///< the reference is good enough
  std::optional<Best> ours = {}, plain = {}, kernel = {};
  std::optional<Best> plainWithEvents =
      {};  ///< peers of row A that find contacts; `plain` and `kernel` step across them
  /// Seconds of the peer over ours, round by round: above 1 we are ahead.
  std::optional<Statistics> toPlain = {}, toKernel = {}, toPlainWithEvents = {};
  /// The fewest evaluations of any method of the row at this error; 0: none reaches it.
  double fewestOurs = 0.0, fewestPlain = 0.0;
};

/// One entry for each target.
std::vector<Entry> entriesOf(const SceneResult& scene);

/// The plain symplectic Euler at its largest stable step, against our fastest at an error: ours over its own.
struct AgainstNaive {
  double step = 0.0;                 ///< [s]
  double error = 0.0;                ///< e_x of the naive loop there
  Statistics ours = {}, naive = {};  ///< seconds
  Statistics ratio = {};             ///< ours / naive, round by round
  std::string method = {};           ///< ours
};
std::optional<AgainstNaive> againstNaive(const SceneResult& scene, double target);

/// The places of a scene's table that are not filled, and its curves without a result: what makes the command fail.
std::vector<std::string> missingCurves(const SceneResult& scene);

}  // namespace muelle::bench
