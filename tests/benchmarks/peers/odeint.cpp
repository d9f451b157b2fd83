#include "odeint.h"

#include "problem.h"

#include <boost/numeric/odeint/stepper/base/symplectic_rkn_stepper_base.hpp>  // the m4 header lacks it
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_mclachlan.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>

namespace muelle::bench {

namespace odeint = boost::numeric::odeint;

namespace {

using Numbers = std::vector<double>;

/// A method with an error estimate; `make` builds it from the tolerance.
template <class Problem, class Make>
class OdeintAdaptive : public PeerContestant<Problem> {
 public:
  OdeintAdaptive(const Problem& problem, std::string method, Make make)
      : PeerContestant<Problem>(problem, "odeint", std::move(method)), make_(make) {}
  bool takesTolerance() const override { return true; }
  bool mayJudge() const override { return this->method() == "fehlberg78" && this->row() == Row::Plain; }

 protected:
  std::string solve(double setting, Path* path) override {
    auto stepper = make_(setting);
    Numbers y = this->start();
    const auto slope = [this](const Numbers& at, Numbers& rate, double t) { this->slope(t, at.data(), rate.data()); };
    const double end = this->duration();
    double t = 0.0, h = 1e-3 * end;
    while (end - t > 1e-14 * end) {
      h = std::min(h, end - t);
      int tries = 0;
      while (stepper.try_step(slope, y, t, h) != odeint::success) {
        if (++tries > 500) return "the step shrinks to nothing at " + std::to_string(t) + " s";
      }
      this->show(path, t, y.data(), y.data() + this->half());
      if (!std::isfinite(y[0]) || h < 1e-18 * end) return this->blownUp(t);
      if (this->problem_.evaluations > mostEvaluations) return "too many evaluations";
    }
    return this->isFinite(y.data(), y.size()) ? "" : this->blownUp(t);
  }

 private:
  Make make_;
};

template <class Problem>
class OdeintRk4 : public PeerContestant<Problem> {
 public:
  explicit OdeintRk4(const Problem& problem) : PeerContestant<Problem>(problem, "odeint", "rk4") {}
  bool takesTolerance() const override { return false; }

 protected:
  std::string solve(double setting, Path* path) override {
    odeint::runge_kutta4<Numbers> stepper;
    Numbers y = this->start();
    const auto slope = [this](const Numbers& at, Numbers& rate, double t) { this->slope(t, at.data(), rate.data()); };
    const long long steps = this->stepsOf(setting);
    const double h = this->duration() / static_cast<double>(steps);
    for (long long step = 1; step <= steps; ++step) {
      stepper.do_step(slope, y, static_cast<double>(step - 1) * h, h);
      const double t = static_cast<double>(step) * h;
      this->show(path, t, y.data(), y.data() + this->half());
      if (step % 256 == 0 && !this->isFinite(y.data(), y.size())) return this->blownUp(t);
    }
    return this->isFinite(y.data(), y.size()) ? "" : this->blownUp(this->duration());
  }
};

/// Methods for x'' = a(t, x), which take positions and velocities apart.
template <class Problem, class Stepper>
class OdeintSymplectic : public PeerContestant<Problem> {
 public:
  OdeintSymplectic(const Problem& problem, std::string method)
      : PeerContestant<Problem>(problem, "odeint", std::move(method)) {}
  bool takesTolerance() const override { return false; }

 protected:
  std::string solve(double setting, Path* path) override {
    const Problem& problem = this->problem_;
    Stepper stepper;
    std::pair<Numbers, Numbers> y(problem.startX(), problem.startV());
    const Numbers none(problem.size());
    const auto force = [&](const Numbers& x, Numbers& a) {
      problem.acceleration(0.0, x.data(), none.data(), a.data());
    };
    const long long steps = this->stepsOf(setting);
    const double h = this->duration() / static_cast<double>(steps);
    for (long long step = 1; step <= steps; ++step) {
      stepper.do_step(force, y, static_cast<double>(step - 1) * h, h);
      const double t = static_cast<double>(step) * h;
      this->show(path, t, y.first.data(), y.second.data());
      if (step % 256 == 0 && !this->isFinite(y.first.data(), problem.size())) return this->blownUp(t);
    }
    return this->isFinite(y.first.data(), problem.size()) ? "" : this->blownUp(this->duration());
  }
};

template <class Problem>
class OdeintVerlet : public PeerContestant<Problem> {
 public:
  explicit OdeintVerlet(const Problem& problem) : PeerContestant<Problem>(problem, "odeint", "velocity_verlet") {}
  bool takesTolerance() const override { return false; }

 protected:
  std::string solve(double setting, Path* path) override {
    const Problem& problem = this->problem_;
    odeint::velocity_verlet<Numbers> stepper;
    std::pair<Numbers, Numbers> y(problem.startX(), problem.startV());
    const auto force = [&](const Numbers& x, const Numbers& v, Numbers& a, double t) {
      problem.acceleration(t, x.data(), v.data(), a.data());
    };
    const long long steps = this->stepsOf(setting);
    const double h = this->duration() / static_cast<double>(steps);
    for (long long step = 1; step <= steps; ++step) {
      stepper.do_step(force, std::make_pair(std::ref(y.first), std::ref(y.second)), static_cast<double>(step - 1) * h,
                      h);
      const double t = static_cast<double>(step) * h;
      this->show(path, t, y.first.data(), y.second.data());
      if (step % 256 == 0 && !this->isFinite(y.first.data(), problem.size())) return this->blownUp(t);
    }
    return this->isFinite(y.first.data(), problem.size()) ? "" : this->blownUp(this->duration());
  }
};

template <class Problem, class Make>
void addAdaptive(const Problem& problem, const char* name, Make make, Contestants& all) {
  all.push_back(std::make_unique<OdeintAdaptive<Problem, Make>>(problem, name, make));
}

/// The ball's phases: in the air and on the ground, each smooth beyond its end.
struct BallPhases {
  double gravity = 0.0, stiffness = 0.0;  ///< k/m
  bool touching = false;

  void operator()(const std::array<double, 2>& y, std::array<double, 2>& rate) const {
    rate[0] = y[1];
    rate[1] = gravity - (touching ? stiffness * y[0] : 0.0);
  }
};

class OdeintBall : public Contestant {
 public:
  explicit OdeintBall(const BenchScene& scene) : scene_(scene) {}
  Row row() const override { return Row::Plain; }
  std::string library() const override { return "odeint"; }
  std::string method() const override { return "dopri5_dense_bisection"; }
  bool takesTolerance() const override { return true; }
  bool locatesEvents() const override { return true; }
  bool mayJudge() const override { return true; }

  RunCost run(double setting, Path* path) override {
    using Numbers2 = std::array<double, 2>;
    const engine::ModelNode& ball = scene_.model.nodes[0];
    BallPhases phase{scene_.model.gravity[0], scene_.model.obstacles[0].material.k / ball.m, false};
    RunCost cost;
    const auto slope = [&](const Numbers2& y, Numbers2& rate, double) {
      ++cost.evaluations;
      phase(y, rate);
    };
    auto stepper = odeint::make_dense_output(setting, setting, odeint::runge_kutta_dopri5<Numbers2>());
    Numbers2 y{ball.x[0], ball.v[0]};
    double h = 1e-3 * scene_.duration, t = 0.0;
    stepper.initialize(y, t, h);
    while (t < scene_.duration) {
      double from = 0.0;
      std::tie(from, t) = stepper.do_step(slope);
      y = stepper.current_state();
      const bool passes = (y[0] < 0.0) != phase.touching;
      if (passes) t = crossing(stepper, phase.touching, from, t, y);
      if (t >= scene_.duration) {
        t = scene_.duration;
        stepper.calc_state(t, y);
      } else if (passes) {
        phase.touching = !phase.touching;
        h = std::min(stepper.current_time_step(), 1e-3 * scene_.duration);
        y[0] = 0.0;
        stepper.initialize(y, t, h);
      }
      if (path != nullptr && path->wants(t)) path->see({t, {y[0]}, {y[1]}});
      if (cost.evaluations > mostEvaluations) {
        cost.failure = "too many evaluations";
        break;
      }
    }
    return cost;
  }

 private:
  /// The time in the last step at which the ball passes the ground's surface, and the state there.
  template <class Stepper>
  static double crossing(Stepper& stepper, bool touching, double from, double to, std::array<double, 2>& y) {
    for (int i = 0; i < 60 && to - from > 1e-15 * to; ++i) {
      const double middle = 0.5 * (from + to);
      stepper.calc_state(middle, y);
      ((y[0] < 0.0) != touching ? to : from) = middle;
    }
    stepper.calc_state(to, y);
    return to;
  }

  const BenchScene& scene_;
};

}  // namespace

template <class Problem>
void addOdeint(const Problem& problem, Contestants& all) {
  all.push_back(std::make_unique<OdeintRk4<Problem>>(problem));
  addAdaptive(
      problem, "dopri5",
      [](double tol) { return odeint::make_controlled(tol, tol, odeint::runge_kutta_dopri5<Numbers>()); }, all);
  addAdaptive(
      problem, "fehlberg78",
      [](double tol) { return odeint::make_controlled(tol, tol, odeint::runge_kutta_fehlberg78<Numbers>()); }, all);
  addAdaptive(
      problem, "bulirsch_stoer", [](double tol) { return odeint::bulirsch_stoer<Numbers>(tol, tol); }, all);
  if (problem.usesVelocity()) return;
  all.push_back(std::make_unique<OdeintVerlet<Problem>>(problem));
  all.push_back(
      std::make_unique<OdeintSymplectic<Problem, odeint::symplectic_rkn_sb3a_mclachlan<Numbers>>>(problem, "sb3a"));
  all.push_back(std::make_unique<OdeintSymplectic<Problem, odeint::symplectic_rkn_sb3a_m4_mclachlan<Numbers>>>(
      problem, "sb3a_m4"));
}

template void addOdeint(const PlainProblem<1>&, Contestants&);
template void addOdeint(const PlainProblem<2>&, Contestants&);
template void addOdeint(const PlainProblem<3>&, Contestants&);
template void addOdeint(const KernelProblem&, Contestants&);

void addOdeintBall(const BenchScene& scene, Contestants& all) { all.push_back(std::make_unique<OdeintBall>(scene)); }

}  // namespace muelle::bench
