#pragma once
#include <vector>

namespace muelle::engine {

/// Rounding allowed when two times are compared: 8 ulp of the larger one [s].
double timeRounding(double a, double b);

/// The times at which a run has to end a step: declared times, output times, its end; ascending, merged where they
/// agree to rounding.
class StopTimes {
 public:
  struct Stop {
    double t = 0.0;
    bool declared = false;  ///< the force jumps here
    bool output = false;    ///< a state is asked for here
  };

  /// \param declared, outputs ascending; those not in (start, end] are left out
  StopTimes(double start, double end, const std::vector<double>& declared, const std::vector<double>& outputs);
  /// The first stop not yet reached; the last one is the end.
  const Stop& next() const { return stops_[next_]; }
  bool finished() const { return next_ == stops_.size(); }
  /// The next stop has been reached.
  void advance() { ++next_; }

 private:
  std::vector<Stop> stops_;
  std::size_t next_ = 0;
};

/// A step to be taken.
struct PlannedStep {
  double t = 0.0;            ///< time at its end [s]
  double length = 0.0;       ///< [s]
  bool reachesStop = false;  ///< ends at the next of the StopTimes
  bool reachesGrid = false;  ///< ends at the next point of the TimeGrid
};

/// The grid of a fixed-step run: t0 + n h. Steps between grid points have length h to the last bit; the times are
/// products, not a running sum, whose rounding would grow with the number of steps.
class TimeGrid {
 public:
  TimeGrid(double t0, double h) : t0_(t0), h_(h) {}
  double h() const { return h_; }
  /// The step from t to the next grid point, or to the stop when it comes first.
  PlannedStep plan(double t, const StopTimes::Stop& stop) const;
  /// To be called after each step: whether it ended at the grid point that plan() aimed at.
  void moved(bool reachedGrid);

 private:
  double point(long long n) const { return t0_ + static_cast<double>(n) * h_; }

  double t0_;
  double h_;
  long long next_ = 1;  // the grid point ahead
  bool onGrid_ = true;  // the last step ended at point next_ - 1
};

}  // namespace muelle::engine
