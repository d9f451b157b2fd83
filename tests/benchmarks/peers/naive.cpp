#include "naive.h"

#include "problem.h"

namespace muelle::bench {

namespace {

using Numbers = std::vector<double>;

/// v += h a(x, v); x += h v.
struct SymplecticEuler {
  static constexpr const char* name = "symplectic_euler";

  template <class Problem>
  static void begin(const Problem&, const Numbers&, const Numbers&, Numbers&) {}
  template <class Problem>
  static void step(const Problem& problem, double t, double, double h, Numbers& x, Numbers& v, Numbers& a) {
    problem.acceleration(t, x.data(), v.data(), a.data());
    for (std::size_t i = 0; i < a.size(); ++i) v[i] += h * a[i];
    for (std::size_t i = 0; i < a.size(); ++i) x[i] += h * v[i];
  }
};

/// x += h v + h^2/2 a; v += h/2 (a + a'); one evaluation a step where the force does not ask for v.
struct VelocityVerlet {
  static constexpr const char* name = "velocity_verlet";

  template <class Problem>
  static void begin(const Problem& problem, const Numbers& x, const Numbers& v, Numbers& a) {
    problem.acceleration(0.0, x.data(), v.data(), a.data());
  }
  template <class Problem>
  static void step(const Problem& problem, double, double end, double h, Numbers& x, Numbers& v, Numbers& a) {
    for (std::size_t i = 0; i < a.size(); ++i) v[i] += 0.5 * h * a[i];
    for (std::size_t i = 0; i < a.size(); ++i) x[i] += h * v[i];
    problem.acceleration(end, x.data(), v.data(), a.data());
    for (std::size_t i = 0; i < a.size(); ++i) v[i] += 0.5 * h * a[i];
  }
};

/// A loop over equal steps, as one writes it for oneself.
template <class Problem, class Method>
class Naive : public PeerContestant<Problem> {
 public:
  explicit Naive(const Problem& problem) : PeerContestant<Problem>(problem, "plain", Method::name) {}
  bool takesTolerance() const override { return false; }

 protected:
  std::string solve(double setting, Path* path) override {
    const Problem& problem = this->problem_;
    const std::size_t n = problem.size();
    Numbers x = problem.startX(), v = problem.startV(), a(n);
    const long long steps = this->stepsOf(setting);
    const double h = this->duration() / static_cast<double>(steps);
    Method::begin(problem, x, v, a);
    for (long long step = 1; step <= steps; ++step) {
      const double t = static_cast<double>(step) * h;
      Method::step(problem, static_cast<double>(step - 1) * h, t, h, x, v, a);
      this->show(path, t, x.data(), v.data());
      if (step % 256 == 0 && !this->isFinite(x.data(), n)) return this->blownUp(t);
    }
    return this->isFinite(x.data(), n) ? "" : this->blownUp(this->duration());
  }
};

}  // namespace

template <class Problem>
void addNaive(const Problem& problem, Contestants& all) {
  all.push_back(std::make_unique<Naive<Problem, SymplecticEuler>>(problem));
  if (!problem.usesVelocity()) all.push_back(std::make_unique<Naive<Problem, VelocityVerlet>>(problem));
}

template void addNaive(const PlainProblem<1>&, Contestants&);
template void addNaive(const PlainProblem<2>&, Contestants&);
template void addNaive(const PlainProblem<3>&, Contestants&);
template void addNaive(const KernelProblem&, Contestants&);

}  // namespace muelle::bench
