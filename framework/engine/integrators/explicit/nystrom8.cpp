#include "engine/integrators/explicit/engines/nystrom.h"
#include "engine/integrators/explicit/methods.h"

namespace muelle::engine {

namespace {

MethodInfo nystrom8Info() {
  MethodInfo info = nystromInfo();
  info.id = "nystrom8";
  info.name = "Runge-Kutta-Nystroem 8(6)";
  info.order = 8;
  info.stages = 8;
  info.imaginaryLimit = 3.1402541625390064973;
  info.source += ": RKN8(6)9FM";
  info.remark =
      "scenes damped by drag (exact) or not at all at tight tolerances (1e-8 to 1e-12): order 8 for eight forces a "
      "step. Energy and angular "
      "momentum drift by its own error";
  return info;
}

}  // namespace

/// RKN8(6)9FM: nine stages, the last of which is the next step's first.
NystromTableau nystrom8Tableau() {
  return {
      .c = {0.0L, 1.0L / 20.0L, 1.0L / 10.0L, 3.0L / 10.0L, 1.0L / 2.0L, 7.0L / 10.0L, 9.0L / 10.0L, 1.0L, 1.0L},
      .a = {{},
            {1.0L / 800.0L},
            {1.0L / 600.0L, 1.0L / 300.0L},
            {9.0L / 200.0L, -9.0L / 100.0L, 9.0L / 100.0L},
            {-66701.0L / 197352.0L, 28325.0L / 32892.0L, -2665.0L / 5482.0L, 2170.0L / 24669.0L},
            {227015747.0L / 304251000.0L, -54897451.0L / 30425100.0L, 12942349.0L / 10141700.0L, -9499.0L / 304251.0L,
             539.0L / 9250.0L},
            {-1131891597.0L / 901789000.0L, 41964921.0L / 12882700.0L, -6663147.0L / 3220675.0L, 270954.0L / 644135.0L,
             -108.0L / 5875.0L, 114.0L / 1645.0L},
            {13836959.0L / 3667458.0L, -17731450.0L / 1833729.0L, 1063919505.0L / 156478208.0L,
             -33213845.0L / 39119552.0L, 13335.0L / 28544.0L, -705.0L / 14272.0L, 1645.0L / 57088.0L},
            {223.0L / 7938.0L, 0.0L, 1175.0L / 8064.0L, 925.0L / 6048.0L, 41.0L / 448.0L, 925.0L / 14112.0L,
             1175.0L / 72576.0L, 0.0L}},
      .b = {223.0L / 7938.0L, 0.0L, 1175.0L / 8064.0L, 925.0L / 6048.0L, 41.0L / 448.0L, 925.0L / 14112.0L,
            1175.0L / 72576.0L, 0.0L, 0.0L},
      .bv = {223.0L / 7938.0L, 0.0L, 5875.0L / 36288.0L, 4625.0L / 21168.0L, 41.0L / 224.0L, 4625.0L / 21168.0L,
             5875.0L / 36288.0L, 223.0L / 7938.0L, 0.0L},
      .error = {-544307.0L / 12215700.0L, 0.0L, 544307.0L / 4963840.0L, -544307.0L / 3722880.0L,
                1632921.0L / 12409600.0L, -544307.0L / 8686720.0L, 544307.0L / 44674560.0L, 0.0L, 0.0L},
      .errorv = {-544307.0L / 12215700.0L, 0.0L, 544307.0L / 4467456.0L, -544307.0L / 2606016.0L,
                 1632921.0L / 6204800.0L, -544307.0L / 2606016.0L, 544307.0L / 4467456.0L, 322012.0L / 3053925.0L,
                 -3.0L / 20.0L},
      .firstSameAsLast = true,
  };
}

std::unique_ptr<Integrator> nystrom8() {
  static const StagePlan plan{nystrom8Info(), accelerationTableau(nystrom8Tableau())};
  return std::make_unique<Nystrom>(plan, nystrom8Tableau);
}

}  // namespace muelle::engine
