#pragma once
#include "figures/layout.h"

#include <fmt/format.h>
#include <string>
#include <utility>

namespace muelle::figures {

/// The lines of a gnuplot script, on a canvas of a given size.
class ScriptText {
 public:
  /// \param width, height of the canvas [px]
  ScriptText(double width, double height) : width_(width), height_(height) {}

  template <class... Args>
  void put(fmt::format_string<Args...> text, Args&&... args) {
    lines_ += fmt::format(text, std::forward<Args>(args)...) + '\n';
  }

  /// A text in a given font ("17", empty: the usual one); nothing where there is no text.
  void putLabel(const std::string& text, const Label& place, const std::string& fontSize = "");

  // gnuplot's measure: fractions of the canvas, y from the bottom.
  std::string x(double pixels) const { return fmt::format("{:.5f}", pixels / width_); }
  std::string y(double pixelsFromTop) const { return fmt::format("{:.5f}", 1.0 - pixelsFromTop / height_); }
  std::string heightOf(double pixels) const { return fmt::format("{:.5f}", pixels / height_); }

  const std::string& lines() const { return lines_; }

 private:
  double width_, height_;
  std::string lines_;
};

/// A gnuplot string that holds the text as it is: between single quotes only these have a meaning.
std::string quoted(std::string text);

/// The same for a name on an axis, which gnuplot takes for the format of a number: there % has a meaning, too.
std::string quotedName(std::string text);

}  // namespace muelle::figures
