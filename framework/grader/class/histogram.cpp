#include "grader/class/histogram.h"

#include "figures/axis.h"
#include "grader/report/format.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace muelle::grader {

namespace {

constexpr double roundOff = 1e-9;

/// The drawing's geometry, in the units of its view box.
struct Layout {
  double width = 720.0, height = 280.0;
  double left = 52.0, right = 14.0, top = 34.0, bottom = 48.0;

  double plotWidth() const { return width - left - right; }
  double plotHeight() const { return height - top - bottom; }
  double floor() const { return height - bottom; }
};

class Drawing {
 public:
  explicit Drawing(const Histogram& histogram) : histogram_(histogram) {
    const int highest = histogram.counts.empty() ? 0 : *std::ranges::max_element(histogram.counts);
    most_ = std::max(highest, 1);
  }

  std::string svg(const std::optional<double>& median) {
    axes();
    for (std::size_t i = 0; i < histogram_.counts.size(); ++i) interval(i);
    if (median) medianLine(*median);
    return fmt::format(
        "<svg class=\"histogram\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Histogram of the total points\">\n"
        "{}</svg>\n",
        layout_.width, layout_.height, body_);
  }

 private:
  double x(double points) const { return layout_.left + layout_.plotWidth() * points / histogram_.most; }
  double y(double students) const { return layout_.floor() - layout_.plotHeight() * students / most_; }

  void line(const char* kind, double x1, double y1, double x2, double y2) {
    body_ += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", kind, x1, y1,
                         x2, y2);
  }

  void text(const char* kind, double atX, double atY, const std::string& text) {
    body_ += fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", kind, atX, atY, text);
  }

  void axes() {
    const double students = std::max(ticStep({0.0, most_}, layout_.plotHeight(), 32.0), 1.0);
    for (double n = 0.0; n <= most_; n += students) {
      line("grid", layout_.left, y(n), layout_.width - layout_.right, y(n));
      text("y", layout_.left - 8.0, y(n) + 4.5, showPoints(n));
    }
    const double points = ticStep({0.0, histogram_.most}, layout_.plotWidth(), 56.0);
    for (int i = 0; points * i <= histogram_.most + roundOff; ++i) {
      line("tic", x(points * i), layout_.floor(), x(points * i), layout_.floor() + 5.0);
      text("x", x(points * i), layout_.floor() + 20.0, showPoints(points * i));
    }
    text("x label", layout_.left + 0.5 * layout_.plotWidth(), layout_.height - 6.0,
         fmt::format("points, of {}", showPoints(histogram_.most)));
    text("label", 6.0, 14.0, "students");
  }

  void interval(std::size_t i) {
    const int count = histogram_.counts[i];
    if (count == 0) return;
    const double from = x(histogram_.low(i)) + 1.0, to = x(histogram_.high(i)) - 1.0;
    const bool last = i + 1 == histogram_.counts.size();
    body_ += fmt::format(
        "<rect class=\"students\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"><title>{} to {}{}: "
        "{}</title></rect>\n",
        from, y(count), std::max(to - from, 1.0), layout_.floor() - y(count), showPoints(histogram_.low(i)),
        last ? "" : "below ", showPoints(histogram_.high(i)), count);
    text("x count", 0.5 * (from + to), y(count) - 5.0, std::to_string(count));
  }

  /// Its words stand above the plot, where no bar reaches.
  void medianLine(double median) {
    line("median", x(median), layout_.top - 14.0, x(median), layout_.floor());
    const double middle = std::clamp(x(median), layout_.left + 90.0, layout_.width - layout_.right - 50.0);
    text("x median", middle, layout_.top - 19.0, "median " + showPoints(median));
  }

  Layout layout_;
  const Histogram& histogram_;
  double most_ = 1.0;
  std::string body_;
};

}  // namespace

double Histogram::high(std::size_t i) const { return std::min(step * static_cast<double>(i + 1), most); }

Histogram histogramOf(const std::vector<double>& values, double most, int intervals) {
  Histogram histogram;
  histogram.most = most;
  if (most <= 0.0) return histogram;
  histogram.step = ticStep({0.0, most}, intervals, 1.0);
  histogram.counts.resize(static_cast<std::size_t>(std::ceil(most / histogram.step - roundOff)));
  const double last = static_cast<double>(histogram.counts.size() - 1);
  for (const double value : values) {
    // Sums of thirds end a round-off below the number that they mean.
    const double interval = std::clamp(std::floor(value / histogram.step + roundOff), 0.0, last);
    ++histogram.counts[static_cast<std::size_t>(interval)];
  }
  return histogram;
}

std::string drawn(const Histogram& histogram, const std::optional<double>& median) {
  return Drawing(histogram).svg(median);
}

}  // namespace muelle::grader
