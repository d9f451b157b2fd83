#pragma once
#include "harness/figure.h"

#include <string>
#include <vector>

namespace muelle::plots {

/// A figure of the lecture: the file plots/figures/NAME.cpp defines `Figure NAME()` in a
/// namespace of its own, muelle::plots::NAME, so that figures need not know each other's names. The id is the name.
struct LectureFigure {
  std::string name;
  Figure (*draw)();  ///< computes the figure with the engine: seconds at most
};

/// All of them, by name.
const std::vector<LectureFigure>& lectureFigures();

}  // namespace muelle::plots
