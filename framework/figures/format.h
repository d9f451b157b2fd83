#pragma once

namespace muelle {

/// What a figure is written as.
enum class Format { Svg, Pdf, Png };

/// "svg": how names of files of that format end, after the dot.
inline const char* extensionOf(Format format) {
  return format == Format::Pdf ? "pdf" : format == Format::Png ? "png" : "svg";
}

}  // namespace muelle
