#pragma once
#include "engine/dynamical_system.h"

#include <functional>

namespace muelle::engine::testing {

/// The state of one unknown at t = 0.
inline State oscillatorAt(double x, double v) { return {0.0, {x}, {v}, {}}; }

/// Balls that fall on a plane z = 0 of stiffness k, damped by d, each alone: F = -m g + max(0, -k z - d v) while z < 0.
/// z_i of the internal variables: 0 live, 1 open, 2 closed. One guard a ball: the height while open, the contact's
/// force while closed.
class PenaltyBalls : public DynamicalSystem, public Switching {
 public:
  PenaltyBalls(int count, double k, double d, double g)
      : mass_(static_cast<std::size_t>(count), 1.0), k_(k), d_(d), g_(g) {}

  int size() const override { return static_cast<int>(mass_.size()); }
  std::span<const double> mass() const override { return mass_; }
  int internalSize() const override { return size(); }
  void force(double t, In x, In v, In z, Out f) const override;
  const Switching* switching() const override { return this; }
  std::string unknownName(int i) const override;

  int guardCount() const override { return size(); }
  void guards(double t, In x, In v, In z, Out g) const override;
  std::string guardName(int i) const override;
  void declaredTimes(double, double, std::vector<double>&) const override {}
  bool commit(State& state, bool frozen) const override;
  void cross(int guard, State& state) const override;
  double sweptBound(double t, In x, In v, In z, double h) const override;

  double thickness = 0.0;  ///< [m] of the plane, for the swept bound; 0: none

 private:
  double contact(double x, double v) const { return -k_ * x - d_ * v; }
  std::vector<double> mass_;
  double k_, d_, g_;
};

/// One mass of 1 kg on which `force` acts; it jumps at the declared times, z_0 counting those passed.
class PulsedMass : public DynamicalSystem, public Switching {
 public:
  PulsedMass(std::function<double(double t, int segment)> force, std::vector<double> times, bool announced = true)
      : force_(std::move(force)), times_(std::move(times)), announced_(announced) {}

  int size() const override { return 1; }
  std::span<const double> mass() const override { return {&mass_, 1}; }
  int internalSize() const override { return 1; }
  void force(double t, In x, In v, In z, Out f) const override;
  bool hasUnannouncedForce() const override { return !announced_; }
  const Switching* switching() const override { return announced_ ? this : nullptr; }

  int guardCount() const override { return 0; }
  void guards(double, In, In, In, Out) const override {}
  std::string guardName(int) const override { return {}; }
  void declaredTimes(double from, double to, std::vector<double>& times) const override;
  bool commit(State& state, bool frozen) const override;
  void cross(int, State&) const override {}
  double sweptBound(double, In, In, In, double h) const override { return h; }

 private:
  int segment(double t) const;
  double mass_ = 1.0;
  std::function<double(double, int)> force_;
  std::vector<double> times_;
  bool announced_;
};

}  // namespace muelle::engine::testing
