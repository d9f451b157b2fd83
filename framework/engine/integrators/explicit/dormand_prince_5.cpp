#include "engine/integrators/explicit/engines/explicit_runge_kutta.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo describe() {
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

ButcherTableau tableau() {
  return {
      .c = {0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0},
      .a = {{},
            {1.0 / 5.0},
            {3.0 / 40.0, 9.0 / 40.0},
            {44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0},
            {19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0},
            {9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0},
            {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0}},
      .b = {35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0, 0.0},
      .error = {71.0 / 57600.0, 0.0, -71.0 / 16695.0, 71.0 / 1920.0, -17253.0 / 339200.0, 22.0 / 525.0, -1.0 / 40.0},
      .firstSameAsLast = true,
  };
}

/// Dormand-Prince 5(4), with its dense output of order 4.
class DormandPrince5 : public ExplicitRungeKutta {
 public:
  DormandPrince5() : ExplicitRungeKutta(describe(), tableau()), tableau_(tableau()) {}

  void interpolate(const System&, const State& from, const State& to, double theta, State& out) override {
    // Weights of the fourth coefficient (Shampine's choice, as in the code DOPRI5 of Hairer and Wanner).
    constexpr double d[] = {-12715105075.0 / 11282082432.0,  0.0,
                            87487479700.0 / 32700410799.0,   -10690763975.0 / 1880347072.0,
                            701980252875.0 / 199316789632.0, -1453857185.0 / 822651844.0,
                            69997945.0 / 29380423.0};
    const double rest = 1.0 - theta;
    double weights[7];
    for (std::size_t j = 0; j < 7; ++j) {
      const double b = tableau_.b[j];
      const double first = j == 0 ? 1.0 : 0.0;
      const double last = j == 6 ? 1.0 : 0.0;
      const double start = first - b;
      weights[j] = theta * (b + rest * (start + theta * (b - last - start + rest * d[j])));
    }
    const double h = to.t - from.t;
    prepareResult(from, theta * h, out);
    combine(weights, from, h, out.x, out.v);
  }

 private:
  ButcherTableau tableau_;
};

}  // namespace

std::unique_ptr<Method> dormandPrince5() { return std::make_unique<DormandPrince5>(); }

}  // namespace muelle::engine
