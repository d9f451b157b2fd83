#pragma once
/// \file
/// The three scenes of the challenge: a rabbit that is squeezed, a stiff cloth that swings, a ball that bounces; what
/// each answers when it is asked for its force. The numbers are those of the public scenes: the hidden ones are near
/// them, and have another draught.

#include "harness/triangle_mesh.h"
#include "harness/types.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <utility>
#include <vector>

namespace scenes {

using muelle::Mat3;
using muelle::MatX;
using muelle::Vec3;
using muelle::VecX;
using Matrix = Eigen::SparseMatrix<double>;

/// What is asked of a scene: how far a coordinate may be off at the end, and how often the force may be asked for it.
struct Goal {
  double error;             ///< [m]
  long best, good, enough;  ///< evaluations of the force; one of the Hessian counts as hessianWeight of them
};

constexpr long hessianWeight = 10;

inline Eigen::Index place(std::size_t node) { return 3 * static_cast<Eigen::Index>(node); }
inline auto nodeOf(const VecX& x, std::size_t node) { return x.segment<3>(place(node)); }

// --- the draught ----------------------------------------------------------------------------------------------------

/// An acceleration along w that waves along w, too: the gradient of a potential, so that energy is kept.
struct Wave {
  Vec3 w;        ///< [rad/m]
  double a;      ///< [m/s^2]
  double phase;  ///< [rad]
};

/// A random field of position: nobody knows it who does not ask.
struct Draught {
  std::vector<Wave> waves;

  /// [m/s^2]
  Vec3 acceleration(const Vec3& x) const {
    Vec3 sum = Vec3::Zero();
    for (const Wave& each : waves) sum += each.a * std::sin(each.w.dot(x) + each.phase) * each.w.normalized();
    return sum;
  }
  /// Its derivative with respect to x [1/s^2].
  Mat3 gradient(const Vec3& x) const {
    Mat3 sum = Mat3::Zero();
    for (const Wave& each : waves) {
      sum += each.a * std::cos(each.w.dot(x) + each.phase) * each.w.normalized() * each.w.transpose();
    }
    return sum;
  }
};

/// The public draught: two waves, n to the metre (about 2 pi of them in a radian), of an acceleration a each.
inline Draught publicDraught(double a, double perMetre) {
  const Vec3 one(2.0 / 3, -1.0 / 3, 2.0 / 3), other(-3.0 / 13, 12.0 / 13, 4.0 / 13);
  return {{{perMetre * one, a, 0.7}, {perMetre * other, a, 2.3}}};
}

// --- bonds ----------------------------------------------------------------------------------------------------------

/// Pulls with k/2 (L^2 / L0^2 - 1) d, where d leads from one node to the other. For small changes of length that is a
/// spring of stiffness k; its energy, k/8 (L^2 - L0^2)^2 / L0^2, is a polynomial.
struct Bond {
  std::size_t a, b;
  double k;       ///< [N/m]
  double square;  ///< of the rest length [m^2]
};

inline double tension(const Bond& bond, const Vec3& d) { return 0.5 * bond.k * (d.squaredNorm() / bond.square - 1); }

inline void addPulls(const std::vector<Bond>& bonds, const VecX& x, VecX& force) {
  for (const Bond& bond : bonds) {
    const Vec3 d = nodeOf(x, bond.b) - nodeOf(x, bond.a);
    const Vec3 pull = tension(bond, d) * d;
    force.segment<3>(place(bond.a)) += pull;
    force.segment<3>(place(bond.b)) -= pull;
  }
}

inline void addDraught(const Draught& draught, const VecX& m, const VecX& x, VecX& force) {
  for (Eigen::Index i = 0; i < x.size(); i += 3) force.segment<3>(i) += m[i] * draught.acceleration(x.segment<3>(i));
}

// --- the rabbit -----------------------------------------------------------------------------------------------------

/// A rabbit that floats. Two hands press it flat from above and below, softly, and let go again.
struct RabbitNumbers {
  double k = 5;        ///< of each side of a triangle [N/m]
  double mass = 0.4;   ///< of all nodes together [kg]
  double press = 150;  ///< what pulls towards the middle, at most [1/s^2]
  Draught draught = publicDraught(0.35, 25);
};

class Rabbit {
 public:
  static constexpr double duration = 0.1, middle = 0.095;  // [s], [m]
  static constexpr Goal goal{1e-7, 500, 1200, 3000};

  Rabbit(const RabbitNumbers& numbers, const muelle::TriangleMesh& mesh)
      : numbers_(numbers), x_(place(mesh.nodes.size())), m_(x_.size()) {
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) x_.segment<3>(place(i)) = mesh.nodes[i];
    m_.setConstant(numbers.mass / static_cast<double>(mesh.nodes.size()));
    for (const auto& corner : mesh.triangles) {
      for (const auto& [a, b] : {std::pair(corner[0], corner[1]), {corner[1], corner[2]}, {corner[2], corner[0]}}) {
        if (a < b) hold(static_cast<std::size_t>(a), static_cast<std::size_t>(b));  // its neighbour has it as b, a
      }
    }
  }

  const VecX& masses() const { return m_; }
  const VecX& positions() const { return x_; }
  VecX velocities() const { return VecX::Zero(x_.size()); }

  VecX force(double t, const VecX& x, const VecX&) const {
    VecX F = VecX::Zero(x.size());
    addPulls(bonds_, x, F);
    addDraught(numbers_.draught, m_, x, F);
    const double grip = std::sin(M_PI * t / duration);
    for (Eigen::Index i = 2; i < x.size(); i += 3) F[i] -= m_[i] * numbers_.press * grip * grip * (x[i] - middle);
    return F;
  }

 private:
  void hold(std::size_t a, std::size_t b) {
    bonds_.push_back({a, b, numbers_.k, (nodeOf(x_, b) - nodeOf(x_, a)).squaredNorm()});
  }

  RabbitNumbers numbers_;
  VecX x_, m_;
  std::vector<Bond> bonds_;
};

// --- the cloth ------------------------------------------------------------------------------------------------------

/// A cloth of threads that hardly stretch. It hangs by its upper side and swings, as a board would at first.
struct ClothNumbers {
  double k = 6e5;      ///< of a thread between two nodes [N/m]
  double mass = 0.5;   ///< of all nodes together [kg]
  double swing = 1.0;  ///< about the upper side, at the beginning [rad/s]
  double g = 9.81;     ///< [m/s^2]
  Draught draught = publicDraught(0.2, 5);
};

class Cloth {
 public:
  static constexpr double duration = 0.4;  // [s]
  static constexpr Goal goal{2e-4, 1400, 7000, 12000};
  static constexpr std::size_t side = 10;  // nodes
  static constexpr double spacing = 0.1;   // [m]

  explicit Cloth(const ClothNumbers& numbers = {})
      : numbers_(numbers), x_(place(side * side)), v_(VecX::Zero(x_.size())), m_(x_.size()) {
    m_.setConstant(numbers.mass / static_cast<double>(side * side));
    for (std::size_t i = 0; i < side * side; ++i) {
      const auto row = static_cast<double>(i / side), column = static_cast<double>(i % side);
      x_.segment<3>(place(i)) = Vec3(spacing * column, 0, -spacing * row);
    }
    nails_ = x_.head(place(side));
    for (std::size_t b = 0; b < side * side; ++b) {
      for (std::size_t a = 0; a < b; ++a) hold(a, b);
    }
    hang();
    for (Eigen::Index i = 1; i < x_.size(); i += 3) v_[i] = -numbers.swing * x_[i + 1];
  }

  const VecX& masses() const { return m_; }
  const VecX& positions() const { return x_; }
  const VecX& velocities() const { return v_; }

  VecX force(double, const VecX& x, const VecX&) const {
    VecX F = VecX::Zero(x.size());
    addPulls(bonds_, x, F);
    addDraught(numbers_.draught, m_, x, F);
    for (Eigen::Index i = 2; i < x.size(); i += 3) F[i] -= m_[i] * numbers_.g;
    F.head(nails_.size()) -= numbers_.k * (x.head(nails_.size()) - nails_);
    return F;
  }

  /// Second derivatives of the energy: minus the derivatives of the force [N/m].
  Matrix hessian(double, const VecX& x) const {
    MatX H = MatX::Zero(x.size(), x.size());
    H.diagonal().head(nails_.size()).setConstant(numbers_.k);
    for (const Bond& bond : bonds_) {
      const Vec3 d = nodeOf(x, bond.b) - nodeOf(x, bond.a);
      const Mat3 block = tension(bond, d) * Mat3::Identity() + bond.k / bond.square * d * d.transpose();
      for (const auto& [i, j] : {std::pair(bond.a, bond.b), {bond.b, bond.a}}) {
        H.block<3, 3>(place(i), place(i)) += block;
        H.block<3, 3>(place(i), place(j)) -= block;
      }
    }
    for (Eigen::Index i = 0; i < x.size(); i += 3) {
      H.block<3, 3>(i, i) -= m_[i] * numbers_.draught.gradient(x.segment<3>(i));
    }
    return H.sparseView();
  }

 private:
  /// Threads along rows and columns, soft bonds across each cell and over two cells: all that are this near.
  void hold(std::size_t a, std::size_t b) {
    const double square = (nodeOf(x_, b) - nodeOf(x_, a)).squaredNorm(), cells = square / (spacing * spacing);
    if (cells < 4.1) bonds_.push_back({a, b, numbers_.k * (cells < 1.1 ? 1 : 0.01), square});
  }

  /// Lets the nodes sink in the plane of the cloth, without draught, until they hang still.
  void hang() {
    const Draught draught = std::exchange(numbers_.draught, {});
    for (int turn = 0; turn < 5; ++turn) {
      MatX H = hessian(0, x_);
      for (Eigen::Index i = 1; i < x_.size(); i += 3) H(i, i) += numbers_.k;  // across its plane nothing holds it
      x_ += H.ldlt().solve(force(0, x_, v_));
    }
    numbers_.draught = draught;
  }

  ClothNumbers numbers_;
  VecX x_, v_, m_, nails_;
  std::vector<Bond> bonds_;
};

// --- the ball -------------------------------------------------------------------------------------------------------

/// A ball that is thrown and bounces four times. The ground, z = 0, presses it up while it is below, by a law that
/// stiffens with the depth and dampens a little.
struct BallNumbers {
  double k = 2e5;       ///< of the ground [N/m^1.5]
  double c = 0.02;      ///< how much harder the ground is on the way in than on the way out [s/m]
  double mass = 0.2;    ///< [kg]
  double drag = 0.002;  ///< of the air [kg/m]
  double height = 1.0;  ///< at the beginning [m]
  double g = 9.81;      ///< [m/s^2]
  Draught draught = publicDraught(0.2, 3);
};

class Ball {
 public:
  static constexpr double duration = 3.0;  // [s]
  static constexpr Goal goal{2e-3, 1600, 20000, 40000};

  explicit Ball(const BallNumbers& numbers = {}) : numbers_(numbers) {}

  VecX masses() const { return VecX::Constant(3, numbers_.mass); }
  VecX positions() const { return Vec3(0, 0, numbers_.height); }
  VecX velocities() const { return Vec3(1.3, 0.4, 0); }

  VecX force(double, const VecX& x, const VecX& v) const {
    const Vec3 place = x, velocity = v;
    Vec3 F = numbers_.mass * numbers_.draught.acceleration(place) - numbers_.drag * velocity.norm() * velocity;
    F.z() -= numbers_.mass * numbers_.g;
    if (place.z() < 0) F.z() += numbers_.k * std::pow(-place.z(), 1.5) * std::max(0.0, 1 - numbers_.c * velocity.z());
    return F;
  }

 private:
  BallNumbers numbers_;
};

}  // namespace scenes
