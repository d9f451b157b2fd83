#include "engine/statics/tension_form.h"

#include "engine/solve/spans.h"
#include "engine/statics/force_density.h"
#include "engine/statics/tension_curvature.h"
#include "engine/statics/tension_matrix.h"
#include "engine/statics/tension_newton.h"
#include "engine/statics/tension_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muelle::engine {

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

/// Tensions that leave the least sum of forces (least squares), where they do better than those that the lengths say:
/// a spring that is drawn at its rest length says nothing, and a stiff one nothing but round-off.
void guessTensions(TensionShape& shape, TensionMatrix& matrix) {
  const bool any = std::ranges::any_of(shape.springs, &TensionSpring::mixed);
  if (!any || !(shape.load > 0.0)) return;
  const double before = shape.imbalance().merit;
  std::vector<double> said;
  double rho = 0.0;
  for (TensionSpring& spring : shape.springs) {
    said.push_back(spring.S);
    if (!spring.mixed) continue;
    spring.S = -spring.rho * (spring.L - spring.L0);
    rho = spring.rho;
  }
  shape.measure();
  matrix.linearise();
  Eigen::VectorXd b = Eigen::VectorXd::Zero(matrix.rows()), x;
  matrix.setPositions(shape.F, b);
  const bool solved = matrix.factoriseLeastSquares(rho) && matrix.solve(b, x);
  for (std::size_t j = 0; solved && j < said.size(); ++j) {
    TensionSpring& spring = shape.springs[j];
    if (spring.mixed) spring.S += spring.rho * x[matrix.tensionRow(j)];
  }
  shape.measure();
  if (solved && shape.imbalance().merit < before) return;
  for (std::size_t j = 0; j < said.size(); ++j) shape.springs[j].S = said[j];
  shape.measure();
}

}  // namespace

struct TensionForm::Parts {
  Parts(const ModelSystem& system, const State& start) : shape(system, start), matrix(shape) {}

  TensionShape shape;
  TensionMatrix matrix;
};

TensionForm::TensionForm(const ModelSystem& system, const State& start)
    : parts_(std::make_unique<Parts>(system, start)) {
  place(start.x);
}

TensionForm::~TensionForm() = default;

void TensionForm::place(In x) {
  TensionShape& shape = parts_->shape;
  shape.put(x);
  shape.chooseUnknownTensions();
  parts_->matrix.forgetRows();
  shape.measure();
  guessTensions(shape, parts_->matrix);
}

void TensionForm::place(In x, const std::vector<double>& tensions) {
  place(x);
  for (TensionSpring& spring : parts_->shape.springs) {
    const double T = tensions[spring.spring];
    if (spring.mixed && std::isfinite(T)) spring.S = T - spring.rho * (spring.L - spring.L0);
  }
  parts_->shape.measure();
}

bool TensionForm::placeByForceDensity() {
  parts_->matrix.forgetRows();
  return engine::placeByForceDensity(parts_->shape);
}

Imbalance TensionForm::solve(int mostFactorisations, bool pulling) {
  return newtonOnTensions(parts_->shape, parts_->matrix, mostFactorisations, pulling);
}

Imbalance TensionForm::imbalance() const { return parts_->shape.imbalance(); }

Curvature TensionForm::curvature() { return curvatureOf(parts_->shape, parts_->matrix); }

std::vector<double> TensionForm::positions() const {
  const TensionShape& shape = parts_->shape;
  std::vector<double> x = shape.start.x;
  shape.compact.scatter(spanOf(shape.hi), x);
  return x;
}

std::vector<double> TensionForm::tensions() const {
  const TensionShape& shape = parts_->shape;
  std::vector<double> result;
  for (const ModelSpring& s : shape.system.model().springs) {
    const double L = (shape.system.position(shape.start, s.a) - shape.system.position(shape.start, s.b)).norm();
    result.push_back(s.unilateral && L > s.L0 ? 0.0 : s.k * (L - s.L0));  // between fixed nodes
  }
  for (const TensionSpring& spring : shape.springs) {
    const double T = spring.tension();
    const bool directed = spring.L > 0.0 || spring.L0 == 0.0 || spring.k == 0.0;
    const bool isRoundOff = std::abs(T) <= 4.0 * eps * spring.stiffness() * spring.L;
    result[spring.spring] = isRoundOff ? 0.0 : directed ? T : std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}

int TensionForm::unknownTensions() const {
  return static_cast<int>(std::ranges::count_if(parts_->shape.springs, &TensionSpring::mixed));
}

double TensionForm::load() const { return parts_->shape.load; }

const Work& TensionForm::work() const { return parts_->shape.work; }

}  // namespace muelle::engine
