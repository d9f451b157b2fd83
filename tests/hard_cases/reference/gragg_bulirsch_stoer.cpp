#include "reference/gragg_bulirsch_stoer.h"

#include <array>
#include <stdexcept>

namespace muelle::hard_cases {

namespace {

constexpr std::size_t columns = 12;

Quad largestDifference(const QuadVector& a, const QuadVector& b) {
  Quad largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Quad size = fmaxq(Quad(1), fabsq(a[i]));
    const Quad difference = fabsq(a[i] - b[i]) / size;
    // A NaN must not pass for a small difference.
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

class Extrapolation {
 public:
  Extrapolation(const Slope& slope, std::size_t size) : slope_(slope), start_(size), middle_(size), k_(size) {
    for (QuadVector& row : table_) row.resize(size);
  }

  /// y after a step of H; returns the difference of the last two extrapolations.
  Quad step(Quad t, const QuadVector& y, Quad H, QuadVector& end) {
    slope_(t, y, slopeAtStart_.empty() ? (slopeAtStart_.resize(y.size()), slopeAtStart_) : slopeAtStart_);
    Quad difference = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      midpoint(t, y, H, static_cast<int>(2 * (j + 1)), end);
      difference = extrapolate(j, end);
    }
    end = table_[columns - 1];
    return difference;
  }

 private:
  /// Gragg's rule with n substeps: leapfrog, even n.
  void midpoint(Quad t, const QuadVector& y, Quad H, int n, QuadVector& end) {
    const Quad h = H / n;
    start_ = y;
    for (std::size_t i = 0; i < y.size(); ++i) middle_[i] = y[i] + h * slopeAtStart_[i];
    for (int m = 1; m < n; ++m) {
      slope_(t + m * h, middle_, k_);
      for (std::size_t i = 0; i < y.size(); ++i) start_[i] += 2 * h * k_[i];
      std::swap(start_, middle_);
    }
    end = middle_;
  }

  /// Aitken and Neville in h^2. table_[i] holds the newest entry of extrapolation degree i.
  Quad extrapolate(std::size_t j, const QuadVector& value) {
    QuadVector lower = value;  // T(j, 0)
    Quad difference = 0;
    for (std::size_t degree = 0; degree < j; ++degree) {
      const Quad ratio = Quad(j + 1) / Quad(j - degree);
      QuadVector higher(value.size());
      for (std::size_t i = 0; i < value.size(); ++i) {
        higher[i] = lower[i] + (lower[i] - table_[degree][i]) / (ratio * ratio - 1);
      }
      table_[degree] = lower;
      difference = largestDifference(higher, lower);
      lower = std::move(higher);
    }
    table_[j] = lower;
    return difference;
  }

  const Slope& slope_;
  std::array<QuadVector, columns> table_;
  QuadVector start_, middle_, k_, slopeAtStart_;
};

}  // namespace

QuadVector integrate(const Slope& slope, QuadVector y, Quad from, Quad to, Quad tolerance) {
  Extrapolation extrapolation(slope, y.size());
  QuadVector end(y.size());
  Quad t = from;
  Quad H = (to - from) / 100;
  while (t < to) {
    const bool last = t + H >= to;
    const Quad length = last ? to - t : H;
    if (t + length == t) throw std::runtime_error("the reference integrator's step vanished");
    const Quad error = extrapolation.step(t, y, length, end) / tolerance;
    const Quad factor = Quad(9) / 10 * powq(fmaxq(error, quad("1e-12")), -Quad(1) / (2 * columns - 1));
    if (error <= 1) {
      t = last ? to : t + length;
      y = end;
      H = length * fminq(factor, Quad(2));
    } else {
      H = length * (isnanq(error) ? quad("0.1") : fmaxq(factor, quad("0.1")));
    }
  }
  return y;
}

}  // namespace muelle::hard_cases
