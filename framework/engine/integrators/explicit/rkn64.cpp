#include "engine/integrators/explicit/engines/nystrom.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo rkn64Info() {
  MethodInfo info = nystromInfo();
  info.id = "rkn64";
  info.name = "Runge-Kutta-Nystroem 6(4)";
  info.order = 6;
  info.stages = 5;
  info.stability = Stability::Never;
  info.imaginaryLimit = 0.0;
  info.source = "Dormand, El-Mikkawy and Prince, IMA J. Numer. Anal. 7 (1987) 235-250: RKN6(4)6FM";
  info.remark =
      "scenes damped by drag or not at all, errors of 1e-2 to 1e-6: five forces a step and few vectors to go through, "
      "so that it gains on orders 8 and 12 where the arrays leave the cache. Linear drag is exact";
  return info;
}

}  // namespace

/// RKN6(4)6FM: six stages, the last of which is the next step's first.
NystromTableau rkn64Tableau() {
  return {
      .c = {0.0L, 1.0L / 10.0L, 3.0L / 10.0L, 7.0L / 10.0L, 17.0L / 25.0L, 1.0L},
      .a = {{},
            {1.0L / 200.0L},
            {-1.0L / 2200.0L, 1.0L / 22.0L},
            {637.0L / 6600.0L, -7.0L / 110.0L, 7.0L / 33.0L},
            {225437.0L / 1968750.0L, -30073.0L / 281250.0L, 65569.0L / 281250.0L, -9367.0L / 984375.0L},
            {151.0L / 2142.0L, 5.0L / 116.0L, 385.0L / 1368.0L, 55.0L / 168.0L, -6250.0L / 28101.0L}},
      .b = {151.0L / 2142.0L, 5.0L / 116.0L, 385.0L / 1368.0L, 55.0L / 168.0L, -6250.0L / 28101.0L, 0.0L},
      .bv = {151.0L / 2142.0L, 25.0L / 522.0L, 275.0L / 684.0L, 275.0L / 252.0L, -78125.0L / 112404.0L, 1.0L / 12.0L},
      .error = {165817.0L / 2677500.0L, -165817.0L / 1450000.0L, 1160719.0L / 17100000.0L, 165817.0L / 2100000.0L,
                -331634.0L / 3512625.0L, 0.0L},
      .errorv = {165817.0L / 2677500.0L, -165817.0L / 1305000.0L, 165817.0L / 1710000.0L, 165817.0L / 630000.0L,
                 -165817.0L / 562020.0L, 0.0L},
      .firstSameAsLast = true,
  };
}

std::unique_ptr<Integrator> rkn64() {
  static const StagePlan plan{rkn64Info(), accelerationTableau(rkn64Tableau())};
  return std::make_unique<Nystrom>(plan, rkn64Tableau);
}

}  // namespace muelle::engine
