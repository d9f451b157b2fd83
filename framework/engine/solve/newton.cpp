#include "engine/solve/newton.h"

#include "base/text/count.h"
#include "engine/solve/dense.h"
#include "engine/solve/spans.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;

constexpr double eps = std::numeric_limits<double>::epsilon();
/// Below this relative residual the energy's differences are near round-off, and the residual decides.
constexpr double nearSolution = 1e-5;
/// Motion that dies out ends below the normal range of doubles, where no digit is left to compare [N s].
constexpr double vanished = 1e-290;

}  // namespace

void Newton::prepare(const DynamicalSystem& system) {
  if (system.linearisation() == nullptr) {
    throw std::invalid_argument("an implicit method needs the derivatives of the force (linearisation)");
  }
  system_ = &system;
  hasMatrix_ = false;
  const auto n = static_cast<Eigen::Index>(system.size());
  for (Point* point : {&here_, &trial_, &probe_}) {
    for (Vector* v : {&point->w, &point->X, &point->V, &point->F, &point->R}) v->setZero(n);
  }
  for (Vector* v : {&step_, &rest_, &floor_, &absolute_, &scratch_}) v->setZero(n);
}

void Newton::evaluate(const Vector& w, Point& point) {
  const ImplicitStage& s = *stage_;
  point.w = w;
  point.X = s.X0 + s.alpha * w;
  point.V = s.V0 + s.beta * w;
  if (s.force) {
    s.force(w, point.X, point.V, point.F);
    work_->forceEvaluations += s.forceCost;
  } else {
    system_->force(s.t, spanOf(point.X), spanOf(point.V), s.z, spanOf(point.F));
    ++work_->forceEvaluations;
  }
  point.R = mass_.cwiseProduct(w) - s.tau * point.F;
  if (s.g.size() > 0) point.R -= s.g;
  point.size = std::sqrt((point.R.array().square() / mass_.array()).sum());
  point.finite = std::isfinite(point.size);
}

double Newton::energy(const Point& point) {
  ++work_->forceEvaluations;
  return system_->potential()->energy(stage_->t, spanOf(point.X), stage_->z);
}

double Newton::relativeResidual(const Point& point, double floorFactor, int& worst) const {
  double largest = 0.0;
  worst = 0;
  for (Eigen::Index i = 0; i < point.R.size(); ++i) {
    const double terms = std::abs(mass_[i] * point.w[i]) + stage_->tau * std::abs(point.F[i]) +
                         (stage_->g.size() > 0 ? std::abs(stage_->g[i]) : 0.0);
    const double excess = std::abs(point.R[i]) - floorFactor * (floor_[i] + eps * terms + vanished);
    if (excess <= 0.0) continue;
    const double relative = terms > 0.0 ? excess / terms : 1.0;
    if (relative > largest) {
      largest = relative;
      worst = static_cast<int>(i);
    }
  }
  return largest;
}

bool Newton::atFloor(const Point& point, double factor) {
  needFloor();
  int worst = 0;
  return relativeResidual(point, factor, worst) == 0.0;
}

bool Newton::factorise(Form form, Factorisation& found) {
  const ImplicitStage& s = *stage_;
  system_->linearisation()->assemble(1.0, s.tau * s.beta, s.tau * s.alpha, s.t, spanOf(here_.X), spanOf(here_.V), s.z,
                                     form, J_);
  ++work_->jacobians;
  floorKnown_ = false;
  floor_.setZero();
  found = solver_.factorise(J_, form != Form::Exact);
  ++work_->factorisations;
  hasMatrix_ = found.usable;
  factors_ = {s.tau, s.alpha, s.beta};
  return found.usable;
}

/// step_ = -J^-1 R.
bool Newton::direction(std::string& failure) {
  failure = solver_.solve(here_.R, step_);
  ++work_->solves;
  step_ = -step_;
  return failure.empty();
}

/// step_ = -R'^-1 R by GMRES with the last factorisation on the right, R' by differences; to a hundredth, which is
/// enough for the next point. Evaluates into probe_: the point that a search has accepted stays in trial_.
bool Newton::krylovDirection() {
  constexpr int most = 40;
  const Eigen::Index n = here_.R.size();
  std::vector<Vector> basis, steps;
  Eigen::MatrixXd hessenberg = Eigen::MatrixXd::Zero(most + 1, most);
  Vector right = Vector::Zero(most + 1);
  right[0] = here_.R.norm();
  basis.push_back(-here_.R / right[0]);
  const double way = std::sqrt(eps) * std::max(here_.X.lpNorm<Eigen::Infinity>(), 1e-300) / stage_->alpha;
  int used = 0;
  Vector coefficients;
  for (int j = 0; j < most && j < n; ++j) {
    const auto row = static_cast<std::size_t>(j);
    Vector step(n);
    ++work_->solves;
    if (!solver_.solve(basis[row], step).empty()) break;
    const double difference = way / step.lpNorm<Eigen::Infinity>();
    evaluate(here_.w + difference * step, probe_);
    if (!probe_.finite) break;
    Vector image = (probe_.R - here_.R) / difference;
    steps.push_back(step);
    for (int i = 0; i <= j; ++i) {
      hessenberg(i, j) = image.dot(basis[static_cast<std::size_t>(i)]);
      image -= hessenberg(i, j) * basis[static_cast<std::size_t>(i)];
    }
    hessenberg(j + 1, j) = image.norm();
    used = j + 1;
    const Eigen::MatrixXd part = hessenberg.topLeftCorner(used + 1, used);
    coefficients = leastSquares(part, right.head(used + 1));
    if ((part * coefficients - right.head(used + 1)).norm() <= 1e-2 * right[0]) break;
    if (!(hessenberg(j + 1, j) > 0.0)) break;
    basis.push_back(image / hessenberg(j + 1, j));
  }
  if (used == 0) return false;
  step_.setZero();
  for (int j = 0; j < used; ++j) step_ += coefficients[j] * steps[static_cast<std::size_t>(j)];
  return step_.allFinite();
}

void Newton::needFloor() {
  if (floorKnown_) return;
  floorKnown_ = true;
  // X = X0 + alpha w may be small by cancellation: its round-off is that of X0.
  absolute_ = (stage_->X0.cwiseAbs() + here_.X.cwiseAbs()) / stage_->alpha +
              (stage_->V0.cwiseAbs() + here_.V.cwiseAbs()) / stage_->beta;
  multiplyAbsolute(J_, absolute_, floor_);
  floor_ *= eps;
}

/// step_ with a new matrix of a form; false, with the reason, where that matrix or its solution is of no use.
bool Newton::newDirection(Form form, std::string& failure) {
  Factorisation found;
  if (factorise(form, found)) return direction(failure);
  failure = found.failure;
  return false;
}

/// Steps along step_ until the incremental potential falls enough (Armijo); `slope` is R . step_.
Newton::Search Newton::searchEnergy(double slope) {
  const ImplicitStage& s = *stage_;
  double energyHere = 0.0;
  bool known = false;
  double length = 1.0;
  for (int halving = 0; halving < 60; ++halving) {
    scratch_ = here_.w + length * step_;
    evaluate(scratch_, trial_);
    if (trial_.finite) {
      // A residual that falls well where the Hessian is definite needs no energy.
      if (trial_.size <= 0.3 * here_.size) return Search::Accepted;
      if (relative_ < nearSolution && trial_.size < here_.size) return Search::Accepted;
      if (!known) {
        energyHere = energy(here_);
        rest_.setZero();
        if (!system_->potential()->isComplete()) {
          system_->potential()->conservativeForce(s.t, spanOf(here_.X), s.z, spanOf(rest_));
          ++work_->forceEvaluations;
          rest_ = here_.F - rest_;
        }
        if (s.g.size() > 0) rest_ += s.g / s.tau;
        known = true;
      }
      const double energyThere = energy(trial_);
      const double ratio = s.tau / s.alpha;
      const double change = length * mass_.cwiseProduct(here_.w).dot(step_) +
                            0.5 * length * length * mass_.dot(step_.cwiseAbs2()) - s.tau * length * rest_.dot(step_) +
                            ratio * (energyThere - energyHere);
      const double slack = 4.0 * eps * ratio * (std::abs(energyHere) + std::abs(energyThere));
      if (std::isfinite(energyThere) && change <= 1e-4 * length * slope + slack) return Search::Accepted;
    }
    length *= 0.5;
  }
  return Search::Failed;
}

Newton::Search Newton::searchResidual() {
  double length = 1.0;
  for (int halving = 0; halving < 40; ++halving) {
    scratch_ = here_.w + length * step_;
    evaluate(scratch_, trial_);
    if (trial_.finite && trial_.size <= (1.0 - 1e-4 * length) * here_.size) return Search::Accepted;
    length *= 0.5;
  }
  return Search::Failed;
}

/// Simplified Newton steps with the last factorisation, as long as each at least halves the residual.
void Newton::keepMatrix() {
  std::string failure;
  for (int i = 0; i < 50 && here_.size > 0.0; ++i) {
    if (!direction(failure)) return;
    scratch_ = here_.w + step_;
    evaluate(scratch_, trial_);
    if (!trial_.finite || trial_.size >= here_.size) return;
    const bool worthwhile = trial_.size < 0.5 * here_.size;
    std::swap(here_, trial_);
    if (!worthwhile) return;
  }
}

bool Newton::converged(double tolerance, int& worst) {
  relative_ = relativeResidual(here_, 0.0, worst);
  if (relative_ <= tolerance) return true;
  needFloor();
  relative_ = relativeResidual(here_, 4.0, worst);
  return relative_ <= tolerance;
}

/// Simplified Newton steps with the matrix of the last solve(), as long as each makes the residual ten times smaller: a
/// new matrix would not do much better. Their number.
int Newton::reuseMatrix(double tolerance) {
  std::string failure;
  int steps = 0, worst = 0;
  for (; steps < 20 && here_.size > 0.0; ++steps) {
    if (steps > 0 && converged(tolerance, worst)) break;
    if (!direction(failure)) break;
    scratch_ = here_.w + step_;
    evaluate(scratch_, trial_);
    if (!trial_.finite || trial_.size > 0.1 * here_.size) break;
    std::swap(here_, trial_);
  }
  return steps;
}

bool Newton::solveWithLastMatrix(const Vector& b, Vector& x, Work& work) {
  if (!hasMatrix_) return false;
  ++work.solves;
  return solver_.solve(b, x).empty();
}

/// Sets out from the guess w, or from 0 where the force there is not finite; an empty string, or the force that is not
/// finite at either.
std::string Newton::setOut(Vector& w) {
  evaluate(w, here_);
  if (here_.finite) return {};
  w.setZero();
  evaluate(w, here_);
  if (here_.finite) return {};
  Eigen::Index bad = 0;
  while (bad < here_.R.size() - 1 && std::isfinite(here_.R[bad])) ++bad;
  return fmt::format("the force on {} is not finite", system_->unknownName(static_cast<int>(bad)));
}

/// A direction that points down, with a new matrix of the form wanted, or of the projected one; false where there is
/// none.
bool Newton::downhill(std::string& failure) {
  const bool ready = newDirection(form_, failure);
  if (!followsPotential() || (ready && here_.R.dot(step_) < 0.0)) return ready;
  // Indefinite (or an exact direction that climbs): the projected Hessian always points down.
  if (form_ == Form::Exact) exactWorks_ = false;
  form_ = Form::Symmetric;
  return newDirection(Form::Projected, failure);
}

/// Goes from here_ along a direction of GMRES, which may lead further than what the search before has `found`; where it
/// does not, that stays.
Newton::Search Newton::searchKrylov(Search found) {
  if (!krylovDirection()) return found;
  if (found == Search::Failed) return searchResidual();
  std::swap(trial_, probe_);
  if (searchResidual() == Search::Failed || trial_.size > probe_.size) std::swap(trial_, probe_);
  return Search::Accepted;
}

/// Goes to a better point (trial_) along the direction found, or along others where that one does not lead there.
Newton::Search Newton::search() {
  const double before = here_.size;
  if (!followsPotential()) {
    const Search found = searchResidual();
    const bool poor = found == Search::Failed || trial_.size > 0.3 * before;
    const bool askKrylov = stage_->force && poor && !atFloor(here_, 64.0);
    return askKrylov ? searchKrylov(found) : found;
  }
  Search found = searchEnergy(here_.R.dot(step_));
  if (found == Search::Accepted || form_ != Form::Symmetric) return found;
  // The lagged forces without potential can mislead the search; the exact Jacobian and the residual do not.
  std::string failure;
  if (exactWorks_ && !system_->potential()->isComplete() && newDirection(Form::Exact, failure)) {
    found = searchResidual();
  }
  if (found == Search::Failed && newDirection(Form::Projected, failure)) found = searchEnergy(here_.R.dot(step_));
  return found;
}

/// Newton steps until the stage is solved; an empty string, or why it is not.
std::string Newton::iterate(const NewtonOptions& options, int& iterations) {
  std::string failure;
  int worst = 0;
  while (here_.size != 0.0) {
    if (iterations == 0) {
      relative_ = relativeResidual(here_, 0.0, worst);
    } else if (converged(options.tolerance, worst)) {
      return {};
    }
    if (iterations == options.mostIterations) {
      return "Newton: no convergence after " + counted(iterations, "iteration");
    }
    ++iterations;
    ++work_->newtonIterations;
    if (!downhill(failure)) return "Newton: " + failure;
    const double before = here_.size;
    if (search() == Search::Failed) {
      // No way down: round-off when the residual is of its size, else a fault.
      return atFloor(here_, 1e3) ? "" : "Newton: no step along the direction makes progress";
    }
    std::swap(here_, trial_);
    const bool slow = here_.size > 0.1 * before;
    const bool lags = followsPotential() && slow && relative_ < 1e-1 && !system_->potential()->isComplete();
    if (lags && exactWorks_) form_ = Form::Exact;
    if (slow && atFloor(here_, 64.0)) return {};
    if (options.simplified) keepMatrix();
  }
  return {};
}

NewtonReport Newton::solve(const DynamicalSystem& system, const ImplicitStage& stage, const NewtonOptions& options,
                           Vector& w, Work& work) {
  stage_ = &stage;
  work_ = &work;
  system_ = &system;
  const std::span<const double> mass = system.mass();
  new (&mass_) Eigen::Map<const Vector>(mass.data(), static_cast<Eigen::Index>(mass.size()));
  floor_.setZero();
  hasMatrix_ = hasMatrix_ && options.reuse && factors_ == std::array{stage.tau, stage.alpha, stage.beta};
  floorKnown_ = !hasMatrix_;
  form_ = followsPotential() ? Form::Symmetric : Form::Exact;
  exactWorks_ = true;
  NewtonReport report;
  report.failure = setOut(w);
  if (!report.failure.empty()) return report;
  if (hasMatrix_) {
    report.iterations = reuseMatrix(options.tolerance);
    work.newtonIterations += report.iterations;
  }
  report.failure = iterate(options, report.iterations);
  if (report.failure.empty() && options.polish && report.iterations > 0) keepMatrix();
  w = here_.w;
  int worst = 0;
  report.residual = relativeResidual(here_, 0.0, worst);
  report.done = report.failure.empty();
  if (!report.done) {
    report.failure += fmt::format("; relative residual {:.1e} at {}", report.residual, system.unknownName(worst));
  }
  return report;
}

}  // namespace muelle::engine
