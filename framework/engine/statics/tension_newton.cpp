#include "engine/statics/tension_newton.h"

#include <algorithm>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;

/// A shift of the matrix that holds back free motions, over its largest entry.
constexpr double slight = 1e-9;

class Walk {
 public:
  Walk(TensionShape& shape, TensionMatrix& matrix, int mostFactorisations, bool pulling)
      : shape_(shape), matrix_(matrix), last_(shape.work.factorisations + mostFactorisations), pulling_(pulling) {}
  void run();

 private:
  bool factorise();
  bool findStep();
  double longestPart() const;
  void move(const Vector& hi, const Vector& lo, const std::vector<double>& S, double part);
  bool improve(const Imbalance& now);

  TensionShape& shape_;
  TensionMatrix& matrix_;
  const long long last_;
  const bool pulling_;
  double shift_ = 0.0;  // [N/m]
  Vector step_;         // in the matrix's rows
};

/// The matrix here; where it is singular, as something is free to move without a force, with a small shift that leaves
/// the rest of the step as it is.
bool Walk::factorise() {
  if (matrix_.factorise(shift_).usable) return true;
  if (shape_.work.factorisations >= last_) return false;
  shift_ = slight * matrix_.largestEntry();
  return matrix_.factorise(shift_).usable;
}

bool Walk::findStep() {
  Vector b = Vector::Zero(matrix_.rows());
  matrix_.setPositions(shape_.F, b);
  for (std::size_t j = 0; j < shape_.springs.size(); ++j) {
    const TensionSpring& spring = shape_.springs[j];
    if (spring.mixed) b[matrix_.tensionRow(j)] = -spring.rho * spring.lengthError();
  }
  return matrix_.solve(b, step_);
}

/// The part of the step that keeps tensions positive, where that is asked for.
double Walk::longestPart() const {
  double part = 1.0;
  for (std::size_t j = 0; pulling_ && j < shape_.springs.size(); ++j) {
    const TensionSpring& spring = shape_.springs[j];
    if (!spring.mixed) continue;
    const double change = spring.rho * step_[matrix_.tensionRow(j)], T = spring.tension();
    if (change < 0.0 && T > 0.0) part = std::min(part, 0.9 * T / -change);
  }
  return part;
}

/// Puts the shape a part of the step away from the positions and tensions given.
void Walk::move(const Vector& hi, const Vector& lo, const std::vector<double>& S, double part) {
  for (Eigen::Index i = 0; i < shape_.size; ++i) {
    const double by = lo[i] + part * step_[matrix_.rowOf(i)];
    shape_.hi[i] = difference(hi[i], -by, shape_.lo[i]);
  }
  for (std::size_t j = 0; j < S.size(); ++j) {
    TensionSpring& spring = shape_.springs[j];
    if (spring.mixed) spring.S = S[j] + part * spring.rho * step_[matrix_.tensionRow(j)];
  }
  shape_.measure();
}

/// Goes along the step as far as that does better than `now`; where nothing does, the shape stays.
bool Walk::improve(const Imbalance& now) {
  const Vector hi = shape_.hi, lo = shape_.lo;
  std::vector<double> S;
  for (const TensionSpring& spring : shape_.springs) S.push_back(spring.S);
  double part = longestPart();
  for (int halving = 0; halving < 12; ++halving, part *= 0.5) {
    move(hi, lo, S, part);
    if (shape_.imbalance().merit < now.merit) return true;
    if (now.atRoundOff) break;
  }
  shape_.hi = hi;
  shape_.lo = lo;
  for (std::size_t j = 0; j < S.size(); ++j) shape_.springs[j].S = S[j];
  shape_.measure();
  return false;
}

void Walk::run() {
  while (shape_.work.factorisations < last_) {
    ++shape_.work.newtonIterations;
    matrix_.linearise();
    shape_.measure();
    const Imbalance now = shape_.imbalance();
    if (now.merit == 0.0 || !factorise() || !findStep()) return;
    if (improve(now)) continue;
    if (now.atRoundOff || shift_ > 0.0) return;
    // Along what costs nothing the step is round-off over round-off: held back, the rest of it helps.
    shift_ = slight * matrix_.largestEntry();
  }
}

}  // namespace

Imbalance newtonOnTensions(TensionShape& shape, TensionMatrix& matrix, int mostFactorisations, bool pulling) {
  Walk(shape, matrix, mostFactorisations, pulling).run();
  return shape.imbalance();
}

}  // namespace muelle::engine
