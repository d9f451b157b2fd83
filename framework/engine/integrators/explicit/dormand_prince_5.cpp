#include "engine/integrators/explicit/engines/stage_integrator.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo dormandPrince5Info() {
  MethodInfo info;
  info.id = "dormand_prince_5";
  info.name = "Dormand-Prince 5(4)";
  info.order = 5;
  info.stages = 6;
  info.adaptive = true;
  info.conservesMomentum = true;
  info.imaginaryLimit = 0.997189008632529915523;
  info.realLimit = 3.30656789263494650372;
  info.formula = "seven stages, the last of which is the next step's first; error from the embedded order 4";
  info.source =
      "Dormand and Prince, J. Comput. Appl. Math. 6 (1980) 19-26; dense output: Hairer, Norsett and Wanner, Solving "
      "Ordinary Differential Equations I (1993), II.6";
  info.remark =
      "the usual choice for moderate tolerances (1e-3 to 1e-7) and damped, forced scenes; at a fixed step its limit on "
      "an undamped mode is only h omega = 0.997";
  return info;
}

/// Dormand-Prince 5(4), with its dense output of order 4.
class DormandPrince5 : public StageIntegrator {
 public:
  using StageIntegrator::StageIntegrator;

  void interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                   State& out) override {
    // Weights of the fourth coefficient (Shampine's choice, as in the code DOPRI5 of Hairer and Wanner).
    constexpr long double d[] = {-12715105075.0L / 11282082432.0L,  0.0L,
                                 87487479700.0L / 32700410799.0L,   -10690763975.0L / 1880347072.0L,
                                 701980252875.0L / 199316789632.0L, -1453857185.0L / 822651844.0L,
                                 69997945.0L / 29380423.0L};
    static const ButcherTableau tableau = dormandPrince5Tableau();
    const long double at = theta, rest = 1.0L - at;
    Coefficients weights(7);
    long double all = 0.0L;
    for (std::size_t j = 0; j < 7; ++j) {
      const long double b = tableau.b[j], first = j == 0 ? 1.0L : 0.0L, last = j == 6 ? 1.0L : 0.0L;
      const long double start = first - b;
      weights[j] = at * (b + rest * (start + at * (b - last - start + rest * d[j])));
      all += weights[j];
    }
    const double h = to.t - from.t;
    prepareResult(from, theta * h, out);
    StageSum inside(squared(weights, tableau.a), weights);
    sum(inside, static_cast<double>(all), from, h, out.x, out.v);
    system.place(out.t, from.z, out.x, out.v);
  }
};

}  // namespace

ButcherTableau dormandPrince5Tableau() {
  return {
      .c = {0.0L, 1.0L / 5.0L, 3.0L / 10.0L, 4.0L / 5.0L, 8.0L / 9.0L, 1.0L, 1.0L},
      .a = {{},
            {1.0L / 5.0L},
            {3.0L / 40.0L, 9.0L / 40.0L},
            {44.0L / 45.0L, -56.0L / 15.0L, 32.0L / 9.0L},
            {19372.0L / 6561.0L, -25360.0L / 2187.0L, 64448.0L / 6561.0L, -212.0L / 729.0L},
            {9017.0L / 3168.0L, -355.0L / 33.0L, 46732.0L / 5247.0L, 49.0L / 176.0L, -5103.0L / 18656.0L},
            {35.0L / 384.0L, 0.0L, 500.0L / 1113.0L, 125.0L / 192.0L, -2187.0L / 6784.0L, 11.0L / 84.0L}},
      .b = {35.0L / 384.0L, 0.0L, 500.0L / 1113.0L, 125.0L / 192.0L, -2187.0L / 6784.0L, 11.0L / 84.0L, 0.0L},
      .error = {71.0L / 57600.0L, 0.0L, -71.0L / 16695.0L, 71.0L / 1920.0L, -17253.0L / 339200.0L, 22.0L / 525.0L,
                -1.0L / 40.0L},
      .firstSameAsLast = true,
  };
}

std::unique_ptr<Integrator> dormandPrince5() {
  static const StagePlan plan(dormandPrince5Info(), dormandPrince5Tableau());
  return std::make_unique<DormandPrince5>(plan);
}

}  // namespace muelle::engine
