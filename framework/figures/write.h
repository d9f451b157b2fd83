#pragma once
#include "figures/format.h"
#include "harness/figure.h"

#include <filesystem>
#include <vector>

namespace muelle {

/// The one way to draw a plot: writes id.dat, id.gp and id.svg into the folder, which is made when missing;
/// `gnuplot id.gp` there draws it again. Throws std::runtime_error with gnuplot's words when it fails, and then leaves
/// nothing behind.
void writeFigure(const Figure& figure, const std::filesystem::path& folder);

/// Writes several figures at once, with a single run of gnuplot (each start costs 20 ms): all of them or none.
/// Throws std::invalid_argument when two share an id; otherwise as writeFigure(). A PNG of a slide has 1280 x 720
/// pixels, of another figure a width of 1280.
void writeFigures(const std::vector<Figure>& figures, const std::filesystem::path& folder,
                  const std::vector<Format>& formats = {Format::Svg});

}  // namespace muelle
