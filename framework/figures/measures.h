#pragma once
#include <cstddef>

/// \file
/// Sizes that every layout keeps, in pixels of a canvas that a slide shows at about twice the size.

namespace muelle::figures {

inline constexpr double canvasWidth = 960;
inline constexpr double plotLeft = 112;  ///< room for the numbers on the y axis, at least in stacked panels
inline constexpr double plotRight = 926;
inline constexpr double labelIndent = 88;  ///< the y label begins so far left of the plot, above the numbers
inline constexpr double titleHeight = 50;
inline constexpr double rowHeight = 26;     ///< a row above a panel: the y label and the key
inline constexpr double headerFoot = 12;    ///< between those rows and the plot, for the topmost number of the y axis
inline constexpr double entryGap = 20;      ///< between names of the key, and between them and labels
inline constexpr double sampleLength = 40;  ///< the piece of line before a name in the key
inline constexpr double sampleGap = 8;
inline constexpr double headingFont = 18;  ///< size of a heading's font where it has room

// Widths of text are on the generous side: the viewer chooses the face.
inline constexpr double characterWidth = 10.0;   ///< in labels, in the key, and of the numbers along an axis (17 px)
inline constexpr double headingCharacter = 9.8;  ///< in a heading of the full size
inline constexpr double nameCharacter = 7.4;     ///< in the names along an axis (13 px)
inline constexpr double titleCharacter = 0.56;   ///< in the title, in sizes of its font

/// Width of so many characters, each `character` wide.
inline double textWidth(std::size_t characters, double character = characterWidth) {
  return character * static_cast<double>(characters);
}

}  // namespace muelle::figures
