#pragma once

/// \file
/// The numbers of gnuplot's line styles: 1 to mostLineStyles for the palette, one each for references,
/// structures and nodes, and for each of the palette one that marks a category of a table and one for hair lines.

namespace muelle::figures {

inline constexpr int mostLineStyles = 12;
inline constexpr int referenceStyle = 20;
inline constexpr int structureStyle = 21;
inline constexpr int nodeStyle = 22;
inline constexpr int cellStyle = 30;  ///< added to the style of a curve
inline constexpr int meshStyle = 50;  ///< added likewise

}  // namespace muelle::figures
