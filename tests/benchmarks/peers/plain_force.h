#pragma once
#include "engine/model/model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

namespace muelle::bench {

/// The right-hand side as a good user of a peer writes it: arrays, an index loop over the springs, everything inlined;
/// free nodes only, D numbers each, in the order of the model. No line is the engine's.
///
/// It takes springs with both dampings, gravity, drag, planes that never pull and may move until they stop, volumes;
/// whatever else a model has is refused.
template <int D>
class PlainForce {
 public:
  /// Throws std::invalid_argument where the model has what this does not.
  explicit PlainForce(const engine::Model& model) {
    refuseTheRest(model);
    const std::array<int, 3> axes =
        D == 2 ? std::array<int, 3>{model.plane[0], model.plane[1], -1} : std::array<int, 3>{0, 1, 2};
    std::vector<int> place(model.nodes.size(), -1);
    for (std::size_t i = 0; i < model.nodes.size(); ++i) {
      const engine::ModelNode& node = model.nodes[i];
      if (node.pinned) continue;
      place[i] = static_cast<int>(user_.size());
      user_.push_back(static_cast<int>(i));
      inverseMass_.push_back(1.0 / node.m);
      drag_.push_back(node.drag / node.m);
      anyDrag_ = anyDrag_ || node.drag > 0.0;
      for (int c = 0; c < D; ++c) startX_.push_back(node.x[axes[static_cast<std::size_t>(c)]]);
      for (int c = 0; c < D; ++c) startV_.push_back(node.v[axes[static_cast<std::size_t>(c)]]);
    }
    for (std::size_t c = 0; c < D; ++c) gravity_[c] = model.gravity[axes[c]];
    for (const engine::ModelSpring& spring : model.springs) addSpring(model, spring, place, axes);
    for (const engine::ModelVolume& volume : model.volumes) addVolume(volume, place);
    for (const engine::Obstacle& obstacle : model.obstacles) addPlane(obstacle, axes);
  }

  std::size_t size() const { return startX_.size(); }
  const std::vector<double>& startX() const { return startX_; }
  const std::vector<double>& startV() const { return startV_; }
  /// The model's number of free node i.
  const std::vector<int>& user() const { return user_; }
  bool usesVelocity() const {
    const auto damped = [](const auto& s) { return s.dRelative > 0.0 || s.dProjected > 0.0; };
    return anyDrag_ || std::ranges::any_of(springs_, damped) || std::ranges::any_of(anchored_, damped) ||
           std::ranges::any_of(planes_, [](const Plane& plane) { return plane.d > 0.0; });
  }

  /// Overwrites a with the accelerations [m/s^2].
  void operator()(double t, const double* x, const double* v, double* a) const {
    const std::size_t nodes = user_.size();
    for (std::size_t i = 0; i < D * nodes; ++i) a[i] = 0.0;
    if (damped_) {
      for (const Spring& spring : springs_) pull<true>(spring, x, v, a);
    } else {
      for (const Spring& spring : springs_) pull<false>(spring, x, v, a);
    }
    for (const Anchored& spring : anchored_) pullToAnchor(spring, x, v, a);
    if constexpr (D == 3) {
      for (const Volume& volume : volumes_) push(volume, x, a);
    }
    for (const Plane& plane : planes_) push(plane, t, x, v, a);
    for (std::size_t i = 0; i < nodes; ++i) {
      for (std::size_t c = 0; c < D; ++c) a[D * i + c] = a[D * i + c] * inverseMass_[i] + gravity_[c];
    }
    if (anyDrag_) {
      for (std::size_t i = 0; i < nodes; ++i) {
        for (std::size_t c = 0; c < D; ++c) a[D * i + c] -= drag_[i] * v[D * i + c];
      }
    }
  }

  /// add(row, column, value) for every entry of da/dx and da/dv, rows 0 ... size() - 1, columns of v from size() on;
  /// the same entries in the same order at each call (some 0), several of one place to be summed. Exact but for the
  /// derivative of a volume's gradient, which is left out.
  template <class Add>
  void jacobian(double t, const double* x, const double* v, Add add) const {
    for (const Spring& s : springs_) {
      double d[D], w[D];
      for (std::size_t c = 0; c < D; ++c) {
        d[c] = x[s.a + c] - x[s.b + c];
        w[c] = v[s.a + c] - v[s.b + c];
      }
      addSpringBlocks(s, d, w, [&](std::size_t r, std::size_t c, double dx, double dv) {
        const double ma = inverseMass_[s.a / D], mb = inverseMass_[s.b / D];
        for (const auto& [row, m] : {std::pair(s.a + r, ma), std::pair(s.b + r, -mb)}) {
          add(row, s.a + c, m * dx);
          add(row, s.b + c, -m * dx);
          add(row, size() + s.a + c, m * dv);
          add(row, size() + s.b + c, -m * dv);
        }
      });
    }
    for (const Anchored& s : anchored_) {
      double d[D], w[D];
      for (std::size_t c = 0; c < D; ++c) {
        d[c] = x[s.a + c] - s.anchor[c];
        w[c] = v[s.a + c];
      }
      addSpringBlocks(s, d, w, [&](std::size_t r, std::size_t c, double dx, double dv) {
        add(s.a + r, s.a + c, inverseMass_[s.a / D] * dx);
        add(s.a + r, size() + s.a + c, inverseMass_[s.a / D] * dv);
      });
    }
    for (const Volume& volume : volumes_) addVolumeBlocks(volume, x, add);
    for (const Plane& plane : planes_) addPlaneBlocks(plane, t, x, v, add);
    for (std::size_t i = 0; i < size(); ++i) add(i, size() + i, -drag_[i / D]);
  }

 private:
  using Vector = std::array<double, D>;
  struct Spring {
    std::size_t a, b;  ///< where their numbers begin
    double k, L0, dRelative, dProjected;
  };
  struct Anchored {
    std::size_t a;
    Vector anchor;
    double k, L0, dRelative, dProjected;
  };
  struct Volume {
    std::array<std::size_t, 4> node;
    double k, V0;
  };
  struct Plane {
    Vector point, normal, velocity;
    double stopTime, k, d;
  };

  static void refuseTheRest(const engine::Model& model) {
    const bool more = elementCount(model) > model.volumes.size() || !model.properties.empty() ||
                      !model.externalForces.empty() || !model.motions.empty();
    if (more || model.dimension != D) throw std::invalid_argument("the plain force lacks a force of this model");
    for (const engine::ModelSpring& spring : model.springs) {
      if (spring.rod || spring.unilateral || spring.isSigned || spring.dampingRatio > 0.0) {
        throw std::invalid_argument("the plain force lacks this kind of spring");
      }
    }
    for (const engine::Obstacle& obstacle : model.obstacles) {
      if (obstacle.kind != engine::Obstacle::Kind::Plane || obstacle.material.mu > 0.0) {
        throw std::invalid_argument("the plain force lacks this kind of obstacle");
      }
    }
  }

  void addSpring(const engine::Model& model, const engine::ModelSpring& s, const std::vector<int>& place,
                 const std::array<int, 3>& axes) {
    const int a = place[static_cast<std::size_t>(s.a)], b = place[static_cast<std::size_t>(s.b)];
    damped_ = damped_ || s.dRelative > 0.0 || s.dProjected > 0.0;
    if (a >= 0 && b >= 0) {
      springs_.push_back(
          {D * static_cast<std::size_t>(a), D * static_cast<std::size_t>(b), s.k, s.L0, s.dRelative, s.dProjected});
    } else if (a >= 0 || b >= 0) {
      Anchored spring{D * static_cast<std::size_t>(std::max(a, b)), {}, s.k, s.L0, s.dRelative, s.dProjected};
      const engine::ModelNode& pin = model.nodes[static_cast<std::size_t>(a < 0 ? s.a : s.b)];
      for (std::size_t c = 0; c < D; ++c) spring.anchor[c] = pin.x[axes[c]];
      anchored_.push_back(spring);
    }
  }

  void addVolume(const engine::ModelVolume& v, const std::vector<int>& place) {
    Volume volume{{}, v.k, v.V0};
    for (std::size_t j = 0; j < 4; ++j) {
      const int free = place[static_cast<std::size_t>(v.nodes[j])];
      if (free < 0) throw std::invalid_argument("the plain force has no volumes with a pinned node");
      volume.node[j] = 3 * static_cast<std::size_t>(free);
    }
    volumes_.push_back(volume);
  }

  void addPlane(const engine::Obstacle& obstacle, const std::array<int, 3>& axes) {
    Plane plane{{}, {}, {}, obstacle.stopTime, obstacle.material.k, obstacle.material.d};
    for (std::size_t c = 0; c < D; ++c) {
      plane.point[c] = obstacle.centre[axes[c]];
      plane.normal[c] = obstacle.normal[axes[c]];
      plane.velocity[c] = obstacle.velocity[axes[c]];
    }
    planes_.push_back(plane);
  }

  template <bool damped>
  static void pull(const Spring& s, const double* x, const double* v, double* f) {
    double d[D], squares = 0.0;
    for (std::size_t c = 0; c < D; ++c) {
      d[c] = x[s.a + c] - x[s.b + c];
      squares += d[c] * d[c];
    }
    const double L = std::sqrt(squares);
    double factor = -s.k * (L - s.L0) / L;
    if constexpr (damped) {
      double along = 0.0;
      for (std::size_t c = 0; c < D; ++c) along += (v[s.a + c] - v[s.b + c]) * d[c];
      factor -= s.dProjected * along / squares;
    }
    for (std::size_t c = 0; c < D; ++c) {
      double force = factor * d[c];
      if constexpr (damped) force -= s.dRelative * (v[s.a + c] - v[s.b + c]);
      f[s.a + c] += force;
      f[s.b + c] -= force;
    }
  }

  static void pullToAnchor(const Anchored& s, const double* x, const double* v, double* f) {
    double d[D], squares = 0.0, along = 0.0;
    for (std::size_t c = 0; c < D; ++c) {
      d[c] = x[s.a + c] - s.anchor[c];
      squares += d[c] * d[c];
      along += v[s.a + c] * d[c];
    }
    const double L = std::sqrt(squares);
    const double factor = -s.k * (L - s.L0) / L - s.dProjected * along / squares;
    for (std::size_t c = 0; c < D; ++c) f[s.a + c] += factor * d[c] - s.dRelative * v[s.a + c];
  }

  /// dF_a/dx and dF_a/dv of a spring, entry by entry; at the other end they are the opposite.
  template <class SpringKind, class Entry>
  static void addSpringBlocks(const SpringKind& s, const double* d, const double* w, Entry entry) {
    double squares = 0.0, along = 0.0;
    for (std::size_t c = 0; c < D; ++c) {
      squares += d[c] * d[c];
      along += w[c] * d[c];
    }
    const double L = std::sqrt(squares), stretched = s.k * (1.0 - s.L0 / L);
    for (std::size_t r = 0; r < D; ++r) {
      for (std::size_t c = 0; c < D; ++c) {
        const double same = r == c ? 1.0 : 0.0, nn = d[r] * d[c] / squares;
        const double damping = s.dProjected * (along * same + d[r] * w[c] - 2.0 * along * nn) / squares;
        entry(r, c, -stretched * (same - nn) - s.k * nn - damping, -s.dProjected * nn - s.dRelative * same);
      }
    }
  }

  template <class Add>
  void addVolumeBlocks(const Volume& volume, const double* x, Add add) const {
    double g[3][3];
    gradientsOf(volume, x, g);
    const auto slope = [&g](std::size_t j, std::size_t c) {
      return j > 0 ? g[j - 1][c] : -(g[0][c] + g[1][c] + g[2][c]);
    };
    for (std::size_t i = 0; i < 12; ++i) {
      const std::size_t row = volume.node[i / 3] + i % 3;
      for (std::size_t j = 0; j < 12; ++j) {
        const double value = -volume.k * slope(i / 3, i % 3) * slope(j / 3, j % 3);
        add(row, volume.node[j / 3] + j % 3, inverseMass_[row / D] * value);
      }
    }
  }

  template <class Add>
  void addPlaneBlocks(const Plane& plane, double t, const double* x, const double* v, Add add) const {
    const auto [level, speed] = placeOf(plane, t);
    for (std::size_t i = 0; i < user_.size(); ++i) {
      double depth = level, inward = speed;
      for (std::size_t c = 0; c < D; ++c) {
        depth -= x[D * i + c] * plane.normal[c];
        inward -= v[D * i + c] * plane.normal[c];
      }
      const double acts = depth > 0.0 && plane.k * depth + plane.d * inward > 0.0 ? inverseMass_[i] : 0.0;
      for (std::size_t r = 0; r < D; ++r) {
        for (std::size_t c = 0; c < D; ++c) {
          const double nn = acts * plane.normal[r] * plane.normal[c];
          add(D * i + r, D * i + c, -plane.k * nn);
          add(D * i + r, size() + D * i + c, -plane.d * nn);
        }
      }
    }
  }

  /// Gradients of the volume by the nodes b, c, d; returns the volume.
  static double gradientsOf(const Volume& volume, const double* x, double (&g)[3][3]) {
    const double* a = x + volume.node[0];
    double e[3][3];
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t c = 0; c < 3; ++c) e[j][c] = x[volume.node[j + 1] + c] - a[c];
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const double *p = e[(j + 1) % 3], *q = e[(j + 2) % 3];
      g[j][0] = (p[1] * q[2] - p[2] * q[1]) / 6.0;
      g[j][1] = (p[2] * q[0] - p[0] * q[2]) / 6.0;
      g[j][2] = (p[0] * q[1] - p[1] * q[0]) / 6.0;
    }
    return e[0][0] * g[0][0] + e[0][1] * g[0][1] + e[0][2] * g[0][2];
  }

  static void push(const Volume& volume, const double* x, double* f) {
    double g[3][3];
    const double V = gradientsOf(volume, x, g);
    const double pressure = -volume.k * (V - volume.V0);
    for (std::size_t c = 0; c < 3; ++c) {
      f[volume.node[0] + c] -= pressure * (g[0][c] + g[1][c] + g[2][c]);
      for (std::size_t j = 0; j < 3; ++j) f[volume.node[j + 1] + c] += pressure * g[j][c];
    }
  }

  /// Its height along the normal [m], and how fast that grows [m/s].
  static std::pair<double, double> placeOf(const Plane& plane, double t) {
    const double moved = std::min(t, plane.stopTime);
    double level = 0.0, speed = 0.0;
    for (std::size_t c = 0; c < D; ++c) {
      level += (plane.point[c] + moved * plane.velocity[c]) * plane.normal[c];
      if (t < plane.stopTime) speed += plane.velocity[c] * plane.normal[c];
    }
    return {level, speed};
  }

  void push(const Plane& plane, double t, const double* x, const double* v, double* f) const {
    const auto [level, speed] = placeOf(plane, t);
    for (std::size_t i = 0; i < user_.size(); ++i) {
      double depth = level, inward = speed;
      for (std::size_t c = 0; c < D; ++c) {
        depth -= x[D * i + c] * plane.normal[c];
        inward -= v[D * i + c] * plane.normal[c];
      }
      if (depth <= 0.0) continue;
      const double force = std::max(0.0, plane.k * depth + plane.d * inward);
      for (std::size_t c = 0; c < D; ++c) f[D * i + c] += force * plane.normal[c];
    }
  }

  std::vector<int> user_;
  std::vector<double> inverseMass_, drag_, startX_, startV_;
  Vector gravity_{};
  std::vector<Spring> springs_;
  std::vector<Anchored> anchored_;
  std::vector<Volume> volumes_;
  std::vector<Plane> planes_;
  bool damped_ = false, anyDrag_ = false;
};

}  // namespace muelle::bench
