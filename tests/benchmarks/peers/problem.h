#pragma once
#include "engine/model/model_system.h"
#include "lab/bench/contestant.h"
#include "lab/bench/engine_contestant.h"
#include "lab/bench/scene.h"
#include "plain_force.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace muelle::bench {

/// A scene as peers see it, x'' = a(t, x, v) in flat arrays: row A. `scene` outlives it.
template <int D>
class PlainProblem {
 public:
  static constexpr Row ofRow = Row::Plain;

  explicit PlainProblem(const BenchScene& scene) : scene_(scene), force_(scene.modelOfPeers()) {}

  const BenchScene& scene() const { return scene_; }
  std::size_t size() const { return force_.size(); }  ///< of x, and of v
  const std::vector<double>& startX() const { return force_.startX(); }
  const std::vector<double>& startV() const { return force_.startV(); }
  bool usesVelocity() const { return force_.usesVelocity(); }
  /// Overwrites a [m/s^2].
  void acceleration(double t, const double* x, const double* v, double* a) const {
    force_(t, x, v, a);
    ++evaluations;
  }
  /// add(row, column, value) for every entry of the slope's matrix, of 2 size() unknowns (x, v); see PlainForce.
  template <class Add>
  void jacobian(double t, const double* x, const double* v, Add add) const {
    for (std::size_t i = 0; i < size(); ++i) add(i, size() + i, 1.0);
    force_.jacobian(t, x, v,
                    [&](std::size_t row, std::size_t column, double value) { add(size() + row, column, value); });
  }
  /// All nodes, numbered as `scene.model`, whatever the order of the peers' own.
  PathPoint point(double t, const double* x, const double* v) const {
    const engine::Model& model = scene_.modelOfPeers();
    const std::array<int, 3> axes =
        D == 2 ? std::array<int, 3>{model.plane[0], model.plane[1], -1} : std::array<int, 3>{0, 1, 2};
    PathPoint result{t, std::vector<double>(D * model.nodes.size()), std::vector<double>(D * model.nodes.size())};
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      for (std::size_t c = 0; c < D; ++c) result.x[D * placeOf(i) + c] = model.nodes[i].x[axes[c]];
    }
    for (std::size_t i = 0; i < force_.user().size(); ++i) {
      const std::size_t place = placeOf(static_cast<std::size_t>(force_.user()[i]));
      for (std::size_t c = 0; c < D; ++c) {
        result.x[D * place + c] = x[D * i + c];
        result.v[D * place + c] = v[D * i + c];
      }
    }
    return result;
  }

  mutable long long evaluations = 0;

 private:
  std::size_t placeOf(std::size_t peerNode) const {
    return scene_.placeOfPeerNode.empty() ? peerNode : scene_.placeOfPeerNode[peerNode];
  }

  const BenchScene& scene_;
  PlainForce<D> force_;
};

/// The same with the engine's force: row B. The arrays have the system's lanes.
class KernelProblem {
 public:
  static constexpr Row ofRow = Row::Kernel;

  KernelProblem(const BenchScene& scene, const engine::ModelSystem& system)
      : scene_(scene), system_(system), start_(system.initialState()) {}

  const BenchScene& scene() const { return scene_; }
  std::size_t size() const { return start_.x.size(); }
  const std::vector<double>& startX() const { return start_.x; }
  const std::vector<double>& startV() const { return start_.v; }
  bool usesVelocity() const { return system_.forceUsesVelocity(); }
  void acceleration(double t, const double* x, const double* v, double* a) const {
    system_.acceleration(t, {x, size()}, {v, size()}, start_.z, {a, size()});
    ++evaluations;
  }
  /// As PlainProblem's.
  template <class Add>
  void jacobian(double t, const double* x, const double* v, Add add) const {
    const engine::Linearisation& linearisation = *system_.linearisation();
    const std::span<const int> lanes = system_.lanes();
    const auto lane = [&lanes](Eigen::Index i) {
      return static_cast<std::size_t>(lanes.empty() ? static_cast<int>(i) : lanes[static_cast<std::size_t>(i)]);
    };
    for (std::size_t i = 0; i < size(); ++i) add(i, size() + i, 1.0);
    for (const bool byVelocity : {false, true}) {
      linearisation.assemble(0.0, byVelocity ? 1.0 : 0.0, byVelocity ? 0.0 : 1.0, t, {x, size()}, {v, size()}, start_.z,
                             engine::Form::Exact, matrix_);
      for (Eigen::Index j = 0; j < matrix_.sparse.outerSize(); ++j) {
        for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix_.sparse, j); entry; ++entry) {
          const std::size_t row = lane(entry.row());
          add(size() + row, lane(j) + (byVelocity ? size() : 0), -system_.inverseMass()[row] * entry.value());
        }
      }
    }
  }
  PathPoint point(double t, const double* x, const double* v) const {
    return pointOf(system_, {t, {x, x + size()}, {v, v + size()}, start_.z});
  }

  mutable long long evaluations = 0;

 private:
  const BenchScene& scene_;
  const engine::ModelSystem& system_;
  State start_;
  mutable engine::SystemMatrix matrix_;
};

}  // namespace muelle::bench
