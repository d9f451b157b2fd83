#pragma once
#include "harness/figure.h"
#include "lab/bench/bars.h"
#include "lab/bench/machine.h"
#include "lab/bench/sweep.h"

#include <string>
#include <vector>

namespace muelle::bench {

/// A scene's table for the terminal: best of ours, best A, best B, ratios at each error.
std::string tableText(const SceneResult& scene);

/// A line for each bar, and how many are met.
std::string barsText(const std::vector<Bar>& bars);

/// Every point of every curve, failed runs included.
std::string pointsCsv(const std::vector<SceneResult>& scenes);
/// The entries of the tables.
std::string planeCsv(const std::vector<SceneResult>& scenes);

/// What was promised and what came out.
std::string barsCsv(const std::vector<Bar>& bars);

/// A page of all: machine, tables, bars, what could not run. Its pictures lie in speed/ beside it. `more`:
/// further sections.
std::string page(const std::vector<SceneResult>& scenes, const std::vector<Bar>& bars, const Machine& machine,
                 const std::vector<std::string>& versions, const std::string& note, const std::string& more);

/// Error against time and against evaluations of the curves that are best at some error, on one slide.
Figure figureOf(const SceneResult& scene);

/// "12 us", "3.4 ms", "56 s": three digits.
std::string timeText(double seconds);

}  // namespace muelle::bench
