#include "engine/integrators/explicit/engines/nystrom_drag.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine {

NystromDrag::NystromDrag(const NystromTableau& tableau)
    : c_(rounded(tableau.c)),
      end_(tableau.b, tableau.bv),
      error_(tableau.error, tableau.errorv),
      firstSameAsLast_(tableau.firstSameAsLast) {
  c_.push_back(1.0);  // the end
  for (const Coefficients& row : tableau.a) sums_.emplace_back(row, Coefficients{});
}

void NystromDrag::prepare(const DynamicalSystem& system, const Tolerance& tolerance) {
  tolerance_ = tolerance;
  const auto n = static_cast<std::size_t>(system.storage());
  const std::span<const double> d = system.drag()->coefficients(), w = system.inverseMass();
  rate_.resize(n);
  double least = HUGE_VAL, most = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    rate_[i] = d[i] * w[i];
    if (w[i] == 0.0) continue;
    least = std::min(least, rate_[i]);
    most = std::max(most, rate_[i]);
  }
  uniform_ = most - least <= 4.0 * std::numeric_limits<double>::epsilon() * most;
  if (uniform_) std::fill(rate_.begin(), rate_.end(), most);
  factors_.resize(c_.size() * kinds());
  h_ = 0.0;
  g_.assign(sums_.size(), n);
  for (StageSum& sum : sums_) sum.readFrom(g_.begins());
  end_.readFrom(g_.begins());
  error_.readFrom(g_.begins());
  for (std::vector<double>* array : {&x_, &y_, &v_, &ye_, &ve_, &zeros_, &dx_, &dv_, &last_, &kept_})
    array->assign(n, 0.0);
  restart();
}

void NystromDrag::restart() {
  startMark_.clear();
  endMark_.clear();
  accepted_ = endKnown_ = false;
}

void NystromDrag::updateFactors(double h) {
  if (h == h_) return;
  h_ = h;
  for (StageSum& sum : sums_) sum.scale(h);
  end_.scale(h);
  error_.scale(h);
  for (std::size_t j = 0; j < c_.size(); ++j) {
    for (std::size_t i = 0; i < kinds(); ++i) {
      const double s = c_[j] * h, cs = rate_[i] * s;
      Factors& f = factors_[j * kinds() + i];
      f.loss = std::expm1(-cs);
      f.free = cs == 0.0 ? s : -f.loss / rate_[i];
      f.half = std::exp(-0.5 * cs);
      f.growth = std::exp(0.5 * cs);
    }
  }
}

void NystromDrag::provideFirst(const DynamicalSystem& system, const State& from, Work& work) {
  const bool goesOn = accepted_ && endKnown_ && endMark_.matches(from);
  const bool again = !goesOn && startMark_.matches(from);
  accepted_ = endKnown_ = false;
  endMark_.clear();
  if (goesOn) {
    std::copy(last_.begin(), last_.end(), g_.data(0));
  } else if (!again) {
    system.drag()->accelerationWithoutDrag(from.t, from.x, from.v, from.z, g_[0]);
    ++work.forceEvaluations;
  }
  startMark_.set(from);
}

double NystromDrag::advance(const DynamicalSystem& system, const State& from, double h, const ErrorScale& scale,
                            State& to, Work& work) {
  const std::size_t n = rate_.size();
  const StageKernels& kernels = stageKernels(n);
  const StageBase base{n, zeros_.data(), zeros_.data(), h};
  updateFactors(h);
  for (std::size_t j = 1; j < sums_.size(); ++j) {
    kernels.stage(base, sums_[j].terms(), 0.0, y_.data(), nullptr);
    for (std::size_t i = 0; i < n; ++i) {
      const Factors& f = factors(j, i);
      x_[i] = from.x[i] + (f.free * from.v[i] + f.half * y_[i]);
      v_[i] = from.v[i];
    }
    const double t = from.t + c_[j] * h;
    const Out a = g_[j];
    system.place(t, from.z, x_, v_);
    system.drag()->accelerationWithoutDrag(t, x_, v_, from.z, a);
    ++work.forceEvaluations;
    if (firstSameAsLast_ && j + 1 == sums_.size()) std::copy(a.begin(), a.end(), last_.begin());
    for (std::size_t i = 0; i < n; ++i) a[i] = factors(j, i).growth * a[i] + 0.25 * rate(i) * rate(i) * y_[i];
  }
  kernels.stage(base, end_.terms(), 0.0, y_.data(), v_.data());
  kernels.stage(base, error_.terms(), 0.0, ye_.data(), ve_.data());
  prepareResult(from, h, to);
  const double allowedX = tolerance_.relative * scale.position, allowedV = tolerance_.relative * scale.velocity;
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Factors& f = factors(c_.size() - 1, i);
    dx_[i] = f.free * from.v[i] + f.half * y_[i];
    dv_[i] = f.loss * from.v[i] + f.half * (v_[i] - 0.5 * rate(i) * y_[i]);
    to.x[i] = from.x[i] + dx_[i];
    to.v[i] = from.v[i] + dv_[i];
    largest = larger(largest, errorRatio(f.half * ye_[i], from.x[i], to.x[i], allowedX));
    largest = larger(largest, errorRatio(f.half * (ve_[i] - 0.5 * rate(i) * ye_[i]), from.v[i], to.v[i], allowedV));
  }
  system.place(to.t, from.z, to.x, to.v);
  return largest;
}

StepResult NystromDrag::step(const DynamicalSystem& system, const State& from, double h, const ErrorScale& scale,
                             State& to, Work& work) {
  provideFirst(system, from, work);
  const double error = advance(system, from, h, scale, to, work);
  endMark_.set(to);
  endKnown_ = firstSameAsLast_;
  return finiteOrFailure(system, from, to, error);
}

void NystromDrag::increments(State& increment) const {
  std::copy(dx_.begin(), dx_.end(), increment.x.begin());
  std::copy(dv_.begin(), dv_.end(), increment.v.begin());
}

void NystromDrag::inside(const DynamicalSystem& system, const State& from, double h, const ErrorScale& scale,
                         State& out, Work& work) {
  if (!startMark_.matches(from)) {
    system.drag()->accelerationWithoutDrag(from.t, from.x, from.v, from.z, g_[0]);
    ++work.forceEvaluations;
    startMark_.set(from);
  }
  kept_.swap(last_);  // the acceleration at the end, which the next step may begin with
  advance(system, from, h, scale, out, work);
  kept_.swap(last_);
}

}  // namespace muelle::engine
