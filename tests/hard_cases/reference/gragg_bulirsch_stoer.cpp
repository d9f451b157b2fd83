#include "reference/gragg_bulirsch_stoer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace muelle::hard_cases {

namespace {

constexpr std::size_t columns = 12;

Quad powerOf(Quad base, Quad exponent) { return powq(base, exponent); }
long double powerOf(long double base, long double exponent) { return std::pow(base, exponent); }

template <class Real>
Real magnitude(Real value) {
  return value < 0 ? -value : value;
}

template <class Real>
Real largestDifference(const std::vector<Real>& a, const std::vector<Real>& b) {
  Real largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Real difference = magnitude(a[i] - b[i]) / std::max(Real(1), magnitude(a[i]));
    if (!(difference == difference)) return difference;  // a NaN must not pass for a small difference
    largest = std::max(largest, difference);
  }
  return largest;
}

template <class Real>
class Extrapolation {
  using Vector = std::vector<Real>;

 public:
  Extrapolation(const SlopeOf<Real>& slope, std::size_t count)
      : slope_(slope), start_(count), middle_(count), k_(count), slopeAtStart_(count) {
    for (Vector& row : table_) row.resize(count);
  }

  /// y after a step of H; returns the difference of the last two extrapolations.
  Real step(Real t, const Vector& y, Real H, Vector& end) {
    slope_(t, y, slopeAtStart_);
    Real difference = 0;
    for (std::size_t j = 0; j < columns; ++j) {
      midpoint(t, y, H, static_cast<int>(2 * (j + 1)), end);
      difference = extrapolate(j, end);
    }
    end = table_[columns - 1];
    return difference;
  }

 private:
  /// Gragg's rule with n substeps: leapfrog, even n.
  void midpoint(Real t, const Vector& y, Real H, int n, Vector& end) {
    const Real h = H / n;
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
  Real extrapolate(std::size_t j, const Vector& value) {
    Vector lower = value;  // T(j, 0)
    Real difference = 0;
    for (std::size_t degree = 0; degree < j; ++degree) {
      const Real ratio = Real(j + 1) / Real(j - degree);
      Vector higher(value.size());
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

  const SlopeOf<Real>& slope_;
  std::array<Vector, columns> table_;
  Vector start_, middle_, k_, slopeAtStart_;
};

template <class Real>
std::vector<Real> drive(const SlopeOf<Real>& slope, std::vector<Real> y, Real from, Real to, Real tolerance) {
  Extrapolation<Real> extrapolation(slope, y.size());
  std::vector<Real> end(y.size());
  Real t = from;
  Real H = (to - from) / 100;
  while (t < to) {
    const bool last = t + H >= to;
    const Real length = last ? to - t : H;
    if (t + length == t) throw std::runtime_error("the reference integrator's step vanished");
    const Real error = extrapolation.step(t, y, length, end) / tolerance;
    const bool finite = error == error;
    const Real least = Real(1) / 1000000 / 1000000;
    const Real factor = Real(9) / 10 * powerOf(error > least ? error : least, -Real(1) / (2 * columns - 1));
    if (error <= 1) {
      t = last ? to : t + length;
      y = end;
      H = length * std::min(factor, Real(2));
    } else {
      H = length * (finite ? std::max(factor, Real(1) / 10) : Real(1) / 10);
    }
  }
  return y;
}

}  // namespace

QuadVector integrate(const Slope& slope, QuadVector y, Quad from, Quad to, Quad tolerance) {
  return drive<Quad>(slope, std::move(y), from, to, tolerance);
}

std::vector<long double> integrate(const SlopeOf<long double>& slope, std::vector<long double> y, long double from,
                                   long double to, long double tolerance) {
  return drive<long double>(slope, std::move(y), from, to, tolerance);
}

}  // namespace muelle::hard_cases
