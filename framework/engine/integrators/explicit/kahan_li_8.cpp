#include "engine/integrators/explicit/engines/composition.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo kahanLi8Info() {
  MethodInfo info;
  info.id = "kahan_li_8";
  info.name = "Kahan-Li 8";
  info.order = 8;
  info.stages = 17;
  info.symplectic = true;
  info.reversible = true;
  info.conservesMomentum = true;
  info.conservesAngularMomentum = true;
  info.imaginaryLimit = 3.09643868000073217261;
  info.realLimit = 3.1481;  // measured: negative substeps amplify what damping should kill
  info.formula = "seventeen velocity Verlet steps of fractions of h, symmetric about the ninth";
  info.source =
      "Kahan and Li, Math. Comp. 66 (1997) 1089-1099; coefficients as in Hairer, Lubich and Wanner, Geometric "
      "Numerical "
      "Integration (2006), V.3.2";
  info.remark =
      "undamped runs of thousands of periods to many digits, energy and angular momentum included. Spring damping "
      "lowers its order to 3";
  return info;
}

}  // namespace

Coefficients kahanLi8Fractions() {
  constexpr long double g[] = {
      0.13020248308889008087881763L, 0.56116298177510838456196441L,  -0.38947496264484728640807860L,
      0.15884190655515560089621075L, -0.39590389413323757733623154L, 0.18453964097831570709183254L,
      0.25837438768632204729397911L, 0.29501172360931029887096624L,  -0.60550853383003451169892108L};
  Coefficients fractions(17);
  for (std::size_t j = 0; j < 17; ++j) fractions[j] = g[j < 9 ? j : 16 - j];
  return fractions;
}

std::unique_ptr<Integrator> kahanLi8() { return std::make_unique<Composition>(kahanLi8Info(), kahanLi8Fractions()); }

}  // namespace muelle::engine
