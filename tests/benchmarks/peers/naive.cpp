#include "naive.h"

#include "problem.h"

namespace muelle::bench {

namespace {

/// v += h a(x, v); x += h v.
template <class Problem>
class NaiveEuler : public PeerContestant<Problem> {
 public:
  explicit NaiveEuler(const Problem& problem) : PeerContestant<Problem>(problem, "plain", "symplectic_euler") {}
  bool takesTolerance() const override { return false; }

 protected:
  std::string solve(double setting, Path* path) override {
    const Problem& problem = this->problem_;
    const std::size_t n = problem.size();
    std::vector<double> x = problem.startX(), v = problem.startV(), a(n);
    const long long steps = this->stepsOf(setting);
    const double h = this->duration() / static_cast<double>(steps);
    for (long long step = 1; step <= steps; ++step) {
      problem.acceleration(static_cast<double>(step - 1) * h, x.data(), v.data(), a.data());
      for (std::size_t i = 0; i < n; ++i) v[i] += h * a[i];
      for (std::size_t i = 0; i < n; ++i) x[i] += h * v[i];
      const double t = static_cast<double>(step) * h;
      this->show(path, t, x.data(), v.data());
      if (step % 256 == 0 && !this->isFinite(x.data(), n)) return this->blownUp(t);
    }
    return this->isFinite(x.data(), n) ? "" : this->blownUp(this->duration());
  }
};

/// x += h v + h^2/2 a; v += h/2 (a + a'); one evaluation a step where the force does not ask for v.
template <class Problem>
class NaiveVerlet : public PeerContestant<Problem> {
 public:
  explicit NaiveVerlet(const Problem& problem) : PeerContestant<Problem>(problem, "plain", "velocity_verlet") {}
  bool takesTolerance() const override { return false; }

 protected:
  std::string solve(double setting, Path* path) override {
    const Problem& problem = this->problem_;
    const std::size_t n = problem.size();
    std::vector<double> x = problem.startX(), v = problem.startV(), a(n);
    const long long steps = this->stepsOf(setting);
    const double h = this->duration() / static_cast<double>(steps);
    problem.acceleration(0.0, x.data(), v.data(), a.data());
    for (long long step = 1; step <= steps; ++step) {
      const double t = static_cast<double>(step) * h;
      for (std::size_t i = 0; i < n; ++i) v[i] += 0.5 * h * a[i];
      for (std::size_t i = 0; i < n; ++i) x[i] += h * v[i];
      problem.acceleration(t, x.data(), v.data(), a.data());
      for (std::size_t i = 0; i < n; ++i) v[i] += 0.5 * h * a[i];
      this->show(path, t, x.data(), v.data());
      if (step % 256 == 0 && !this->isFinite(x.data(), n)) return this->blownUp(t);
    }
    return this->isFinite(x.data(), n) ? "" : this->blownUp(this->duration());
  }
};

}  // namespace

template <class Problem>
void addNaive(const Problem& problem, Contestants& all) {
  all.push_back(std::make_unique<NaiveEuler<Problem>>(problem));
  if (!problem.usesVelocity()) all.push_back(std::make_unique<NaiveVerlet<Problem>>(problem));
}

template void addNaive(const PlainProblem<1>&, Contestants&);
template void addNaive(const PlainProblem<2>&, Contestants&);
template void addNaive(const PlainProblem<3>&, Contestants&);
template void addNaive(const KernelProblem&, Contestants&);

}  // namespace muelle::bench
