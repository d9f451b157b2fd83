#include "support/spring_network.h"

#include <algorithm>
#include <utility>

namespace muelle::engine::testing {

namespace {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

}  // namespace

SpringNetwork::SpringNetwork(int dimension, const std::vector<double>& mass, std::vector<Spring> springs,
                             Eigen::VectorXd gravity, double drag)
    : dimension_(dimension), springs_(std::move(springs)), gravity_(std::move(gravity)), drag_(drag) {
  for (const double m : mass) mass_.insert(mass_.end(), index(dimension), m);
  complete_ = drag == 0.0 && std::ranges::all_of(springs_, [](const Spring& s) { return s.damping == 0.0; });
}

Vector SpringNetwork::offset(const Spring& s, In x) const {
  Vector d(dimension_);
  for (int c = 0; c < dimension_; ++c) {
    d[c] = x[index(s.a * dimension_ + c)] - (s.b < 0 ? s.anchor[c] : x[index(s.b * dimension_ + c)]);
  }
  return d;
}

Vector SpringNetwork::relativeVelocity(const Spring& s, In v) const {
  Vector u(dimension_);
  for (int c = 0; c < dimension_; ++c) {
    u[c] = v[index(s.a * dimension_ + c)] - (s.b < 0 ? 0.0 : v[index(s.b * dimension_ + c)]);
  }
  return u;
}

void SpringNetwork::add(const Spring& s, const Vector& onA, Out f) const {
  for (int c = 0; c < dimension_; ++c) {
    f[index(s.a * dimension_ + c)] += onA[c];
    if (s.b >= 0) f[index(s.b * dimension_ + c)] -= onA[c];
  }
}

void SpringNetwork::addGravity(Out f) const {
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    f[i] += mass_[i] * gravity_[static_cast<Eigen::Index>(i % index(dimension_))];
  }
}

void SpringNetwork::conservativeForce(double, In x, In, Out f) const {
  std::ranges::fill(f, 0.0);
  addGravity(f);
  for (const Spring& s : springs_) {
    const Vector d = offset(s, x);
    const double L = d.norm();
    if (L > 0.0) add(s, -s.k * (1.0 - s.L0 / L) * d, f);
  }
}

void SpringNetwork::force(double t, In x, In v, In z, Out f) const {
  conservativeForce(t, x, z, f);
  for (std::size_t i = 0; i < mass_.size(); ++i) f[i] -= drag_ * v[i];
  for (const Spring& s : springs_) {
    if (s.damping == 0.0) continue;
    const Vector n = offset(s, x).normalized();
    add(s, -s.damping * relativeVelocity(s, v).dot(n) * n, f);
  }
}

double SpringNetwork::energy(double, In x, In) const {
  double E = 0.0;
  for (const Spring& s : springs_) {
    const double stretch = offset(s, x).norm() - s.L0;
    E += 0.5 * s.k * stretch * stretch;
  }
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    E -= mass_[i] * gravity_[static_cast<Eigen::Index>(i % index(dimension_))] * x[i];
  }
  return E;
}

double SpringNetwork::totalEnergy(const State& state) const {
  double E = energy(state.t, state.x, state.z);
  for (std::size_t i = 0; i < mass_.size(); ++i) E += 0.5 * mass_[i] * state.v[i] * state.v[i];
  return E;
}

void SpringNetwork::discreteGradientForce(double, In xa, In xb, In, Out f) const {
  std::ranges::fill(f, 0.0);
  addGravity(f);
  for (const Spring& s : springs_) {
    const Vector da = offset(s, xa), db = offset(s, xb);
    const double sum = da.norm() + db.norm();
    if (sum > 0.0) add(s, -s.k * (1.0 - 2.0 * s.L0 / sum) * 0.5 * (da + db), f);
  }
}

void SpringNetwork::assemble(double cM, double cD, double cK, double, In x, In v, In, Form form,
                             SystemMatrix& J) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size(); ++i) entries.emplace_back(i, i, cM * mass_[index(i)] + cD * drag_);
  J.symmetric = true;
  for (const Spring& s : springs_) {
    const Vector d = offset(s, x), u = relativeVelocity(s, v);
    const double L = d.norm();
    const Vector n = d / L;
    const Matrix along = n * n.transpose(), across = Matrix::Identity(dimension_, dimension_) - along;
    const double transverse = 1.0 - s.L0 / L;
    Matrix block = cK * s.k * (along + (form == Form::Projected ? std::max(0.0, transverse) : transverse) * across);
    block += cD * s.damping * along;
    if (form == Form::Exact && s.damping != 0.0) {
      block += cK * s.damping / L * (n * (across * u).transpose() + u.dot(n) * across);
      J.symmetric = false;
    }
    for (int r = 0; r < dimension_; ++r) {
      for (int c = 0; c < dimension_; ++c) {
        const int a = s.a * dimension_, b = s.b * dimension_;
        entries.emplace_back(a + r, a + c, block(r, c));
        if (s.b < 0) continue;
        entries.emplace_back(b + r, b + c, block(r, c));
        entries.emplace_back(a + r, b + c, -block(r, c));
        entries.emplace_back(b + r, a + c, -block(r, c));
      }
    }
  }
  J.sparse.resize(size(), size());
  J.sparse.setFromTriplets(entries.begin(), entries.end());
}

Constraint SpringNetwork::constraintOf(const Spring& s, In x) const {
  Constraint out;
  const Vector d = offset(s, x);
  const double L = d.norm();
  out.kind = Constraint::Kind::Distance;
  out.value = L - s.L0;
  out.stiffness = s.k;
  out.damping = s.damping;
  for (const int node : {s.a, s.b}) {
    if (node < 0) continue;
    for (int c = 0; c < dimension_; ++c) {
      out.lane[index(out.count)] = node * dimension_ + c;
      out.gradient[index(out.count)] = (node == s.a ? 1.0 : -1.0) * d[c] / L;
      ++out.count;
    }
  }
  return out;
}

void SpringNetwork::evaluate(double, In x, In, const ConstraintBlocks::Take& take) const {
  std::vector<Constraint> all;
  for (const Spring& s : springs_) {
    all.push_back(constraintOf(s, x));
    all.back().index = static_cast<int>(all.size()) - 1;
  }
  take(all);
}

void SpringNetwork::project(double, In, const ConstraintProjection& projection) const {
  for (const Spring& s : springs_) projection(constraintOf(s, {projection.x, mass_.size()}));
}

void SpringNetwork::externalForce(double, In, In v, In, Out f) const {
  std::ranges::fill(f, 0.0);
  addGravity(f);
  for (std::size_t i = 0; i < mass_.size(); ++i) f[i] -= drag_ * v[i];
}

}  // namespace muelle::engine::testing
