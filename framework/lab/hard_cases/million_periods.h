#pragma once
#include "harness/figure.h"

#include <functional>
#include <string>
#include <vector>

namespace muelle::hard_cases {

/// One method on H01 over all of its 62,831,853 steps of 0.1 s: a million periods.
struct MillionPeriods {
  std::string method;        ///< id of the catalogue
  bool compensated = false;  ///< with compensated summation
  long long steps = 0;       ///< taken; fewer when the motion overflowed or died out
  double x = 0.0, v = 0.0;   ///< at the end [m], [m/s]
  double offState = 0.0;  ///< largest distance of (x, v) from the method's own discrete solution; NaN: none is stated
  double energy = 0.0;    ///< at the end [J], 0.5 at the start
  double least = 0.0, most = 0.0;  ///< energy over the whole run [J]
  double drift = 0.0;              ///< relative change of the invariant that the method keeps; NaN: it keeps none
  double log10Energy = 0.0;        ///< of the end; carried on at the same rate where the doubles ended before
  std::string verdict;             ///< empty: within the case's acceptance; else what is not
};

/// A run of all of them.
struct H01InFull {
  std::string date;  ///< of the run, "2026-11-29"
  std::vector<MillionPeriods> rows;
};

/// Runs them, about 4e8 steps, with the date given. `progress` is called with the fraction done.
H01InFull runH01InFull(const std::string& date, const std::function<void(double)>& progress);

/// The run that is kept with the project: h01_in_full.json beside this file. Throws std::runtime_error when unreadable.
H01InFull keptH01InFull();
std::string toJson(const H01InFull& run);

/// What the case accepts, in words; empty when the row is within it.
std::string judged(const MillionPeriods& row);

/// The table of the page, in Markdown, and the figure.
std::string h01Table(const H01InFull& run);
Figure h01Figure(const H01InFull& run);

}  // namespace muelle::hard_cases
