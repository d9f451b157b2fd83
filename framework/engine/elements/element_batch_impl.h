#pragma once
/// \file
/// Bodies of ElementBatch, for the files that instantiate it.

#include "engine/elements/element_batch.h"
#include "engine/forces/positive_part.h"

namespace muelle::engine {

template <int D, class Element>
void ElementBatch<D, Element>::addForce(const Configuration& at, double* f) const {
  for (const Element& element : elements_) scatter(element, -element.gradient(gather(element, at.x)), f);
}

template <int D, class Element>
double ElementBatch<D, Element>::energy(const Configuration& at) const {
  double sum = 0.0;
  for (const Element& element : elements_) sum += element.energy(gather(element, at.x));
  return sum;
}

template <int D, class Element>
void ElementBatch<D, Element>::addDiscreteGradientForce(const Configuration& a, const Configuration& b,
                                                        double* f) const {
  for (const Element& element : elements_) {
    scatter(element, -element.discreteGradient(gather(element, a.x), gather(element, b.x)), f);
  }
}

template <int D, class Element>
void ElementBatch<D, Element>::couple(MatrixPattern& pattern) const {
  for (const Element& element : elements_) pattern.couple(element.nodes);
}

template <int D, class Element>
void ElementBatch<D, Element>::bind(const MatrixPattern& pattern) {
  slots_.resize(elements_.size());
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(N); ++i) {
      for (std::size_t j = 0; j < static_cast<std::size_t>(N); ++j) {
        slots_[e][i * N + j] = pattern.slot(elements_[e].nodes[i], elements_[e].nodes[j]);
      }
    }
  }
}

template <int D, class Element>
void ElementBatch<D, Element>::addDerivatives(const Configuration& at, double, double cK, Form form,
                                              double* values) const {
  if (cK == 0.0) return;
  for (std::size_t e = 0; e < elements_.size(); ++e) {
    Matrix K = elements_[e].hessian(gather(elements_[e], at.x));
    if (form == Form::Projected) keepPositivePart(K);
    for (int i = 0; i < N; ++i) {
      for (int j = 0; j < N; ++j) {
        addBlock<D>(values, slots_[e][static_cast<std::size_t>(i * N + j)], cK, K.template block<D, D>(D * i, D * j));
      }
    }
  }
}

template <int D, class Element>
bool ElementBatch<D, Element>::evaluate(int j, const Configuration& at, Constraint& out) const {
  const Element& element = elements_[static_cast<std::size_t>(j)];
  Vector gradient;
  double k = 0.0;
  if (!element.constraint(gather(element, at.x), out.value, k, gradient) || !(k > 0.0)) return false;
  out.kind = Constraint::Kind::Other;
  out.stiffness = k;
  out.damping = 0.0;
  out.count = 0;
  for (int i = 0; i < N; ++i) {
    for (int c = 0; c < D; ++c) {
      out.lane[static_cast<std::size_t>(out.count)] = layout_.lane(element.nodes[static_cast<std::size_t>(i)], c);
      out.gradient[static_cast<std::size_t>(out.count)] = gradient[D * i + c];
      ++out.count;
    }
  }
  return true;
}

template <int D, class Element>
void ElementBatch<D, Element>::project(const Configuration& at, const ConstraintProjection& projection) const {
  sweepConstraints(
      0, constraintCount(), [&](int j, Constraint& c) { return evaluate(j, at, c); }, projection);
}

template <int D, class Element>
void ElementBatch<D, Element>::evaluateConstraints(const Configuration& at, int first, ConstraintBlocks& blocks) const {
  sweepConstraints(
      first, constraintCount(), [&](int j, Constraint& c) { return evaluate(j, at, c); }, blocks);
}

}  // namespace muelle::engine
