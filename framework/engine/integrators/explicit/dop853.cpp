#include "engine/integrators/explicit/engines/stage_integrator.h"
#include "engine/integrators/explicit/methods.h"

#include <algorithm>
#include <cmath>

namespace muelle::engine {

namespace {

MethodInfo dop853Info() {
  MethodInfo info;
  info.id = "dop853";
  info.name = "Dormand-Prince 8(5,3)";
  info.order = 8;
  info.stages = 12;
  info.adaptive = true;
  info.conservesMomentum = true;
  info.imaginaryLimit = 5.9603598117027793985;
  info.realLimit = 6.3936515228510649442;
  info.formula = "twelve stages; error from the embedded orders 5 and 3 together; dense output of order 7";
  info.source = "Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I (1993), II.5 and II.6: DOP853";
  info.remark =
      "tight tolerances (1e-7 to 1e-13) with damping or any other force; the reference for scenes where a Nystroem "
      "method does not apply";
  return info;
}

/// Weights of the embedded third order: on stages 1, 9 and 12.
constexpr long double third[] = {0.244094488188976377952755905512L, 0.733846688281611857341361741547L,
                                 0.220588235294117647058823529412e-1L};

/// The order 5 estimate comes first, then that of order 3.
Coefficients toThird() {
  Coefficients weights = dop853Tableau().b;
  weights[0] -= third[0];
  weights[8] -= third[1];
  weights[11] -= third[2];
  return weights;
}

/// The dense output: three more stages, of which each has the slopes before it and the end's.
struct Dense {
  Dense();
  std::vector<Coefficients> rows;  ///< of all 16 slopes
  StageSum extra[3];
  double times[3];
  Coefficients weights;            ///< of the step
  std::vector<Coefficients> last;  ///< of the last four coefficients of the interpolant
};

Dense::Dense() : rows(dop853Tableau().a), weights(dop853Tableau().b), last(dop853Dense().d) {
  const DenseTableau dense = dop853Dense();
  rows.push_back(weights);
  for (std::size_t i = 0; i < 3; ++i) {
    extra[i] = StageSum(squared(dense.a[i], rows), dense.a[i]);
    rows.push_back(dense.a[i]);
    times[i] = static_cast<double>(dense.c[i]);
  }
}

const Dense& denseOutput() {
  static const Dense dense;
  return dense;
}

class DormandPrince853 : public StageIntegrator {
 public:
  explicit DormandPrince853(const StagePlan& plan) : StageIntegrator(plan) { reserve(4); }

  void prepare(const DynamicalSystem& system, const Tolerance& tolerance) override {
    StageIntegrator::prepare(system, tolerance);
    x_.assign(lanes(), 0.0);
    v_.assign(lanes(), 0.0);
  }

  StepResult step(const DynamicalSystem& system, const State& from, double h, State& to) override {
    denseReady_ = false;
    return StageIntegrator::step(system, from, h, to);
  }

  void interpolate(const DynamicalSystem& system, const State& from, const State& to, double theta,
                   State& out) override {
    const double h = to.t - from.t;
    prepareDense(system, from, to, h);
    const Dense& dense = denseOutput();
    const long double at = theta, rest = 1.0L - at;
    Coefficients weights(16);
    long double all = 0.0L;
    for (std::size_t j = 0; j < 16; ++j) {
      const long double b = j < 12 ? dense.weights[j] : 0.0L;
      const long double start = (j == 0 ? 1.0L : 0.0L) - b;
      const long double end = b - (j == 12 ? 1.0L : 0.0L) - start;
      const long double tail =
          dense.last[0][j] + at * (dense.last[1][j] + rest * (dense.last[2][j] + at * dense.last[3][j]));
      weights[j] = at * (b + rest * (start + at * (end + rest * tail)));
      all += weights[j];
    }
    prepareResult(from, theta * h, out);
    StageSum inside(squared(weights, dense.rows), weights);
    sum(inside, static_cast<double>(all), from, h, out.x, out.v);
    system.place(out.t, from.z, out.x, out.v);
  }

 protected:
  /// Hairer's combination: the fifth-order estimate, reduced where the third-order one says that it is overcautious.
  double combined(const StageEnd& end) const override {
    const double fifth = end.largest[0], wide = end.largest[1];
    const double denominator = std::sqrt(fifth * fifth + 0.01 * wide * wide);
    return denominator == 0.0 ? 0.0 : fifth * fifth / denominator;
  }

 private:
  /// The acceleration at the end and the three stages of the dense output, once a step and only when asked for.
  void prepareDense(const DynamicalSystem& system, const State& from, const State& to, double h) {
    if (denseReady_) return;
    ensureEnd(system, from, to);
    for (std::size_t i = 0; i < 3; ++i) {
      StageSum stage = denseOutput().extra[i];
      const double at = denseOutput().times[i];
      sum(stage, at, from, h, x_, v_);
      evaluate(system, from.t + at * h, x_, v_, from.z, 13 + i);
    }
    denseReady_ = true;
  }

  std::vector<double> x_, v_;
  bool denseReady_ = false;
};

}  // namespace

ButcherTableau dop853Tableau() {
  return {
      .c = {0.0L, 0.526001519587677318785587544488e-01L, 0.789002279381515978178381316732e-01L,
            0.118350341907227396726757197510L, 0.281649658092772603273242802490L, 0.333333333333333333333333333333L,
            0.25L, 0.307692307692307692307692307692L, 0.651282051282051282051282051282L, 0.6L,
            0.857142857142857142857142857142L, 1.0L},
      .a = {{},
            {5.26001519587677318785587544488e-2L},
            {1.97250569845378994544595329183e-2L, 5.91751709536136983633785987549e-2L},
            {2.95875854768068491816892993775e-2L, 0.0L, 8.87627564304205475450678981324e-2L},
            {2.41365134159266685502369798665e-1L, 0.0L, -8.84549479328286085344864962717e-1L,
             9.24834003261792003115737966543e-1L},
            {3.7037037037037037037037037037e-2L, 0.0L, 0.0L, 1.70828608729473871279604482173e-1L,
             1.25467687566822425016691814123e-1L},
            {3.7109375e-2L, 0.0L, 0.0L, 1.70252211019544039314978060272e-1L, 6.02165389804559606850219397283e-2L,
             -1.7578125e-2L},
            {3.70920001185047927108779319836e-2L, 0.0L, 0.0L, 1.70383925712239993810214054705e-1L,
             1.07262030446373284651809199168e-1L, -1.53194377486244017527936158236e-2L,
             8.27378916381402288758473766002e-3L},
            {6.24110958716075717114429577812e-1L, 0.0L, 0.0L, -3.36089262944694129406857109825L,
             -8.68219346841726006818189891453e-1L, 2.75920996994467083049415600797e+1L,
             2.01540675504778934086186788979e+1L, -4.34898841810699588477366255144e+1L},
            {4.77662536438264365890433908527e-1L, 0.0L, 0.0L, -2.48811461997166764192642586468L,
             -5.90290826836842996371446475743e-1L, 2.12300514481811942347288949897e+1L,
             1.52792336328824235832596922938e+1L, -3.32882109689848629194453265587e+1L,
             -2.03312017085086261358222928593e-2L},
            {-9.3714243008598732571704021658e-1L, 0.0L, 0.0L, 5.18637242884406370830023853209L,
             1.09143734899672957818500254654L, -8.14978701074692612513997267357L, -1.85200656599969598641566180701e+1L,
             2.27394870993505042818970056734e+1L, 2.49360555267965238987089396762L, -3.0467644718982195003823669022L},
            {2.27331014751653820792359768449L, 0.0L, 0.0L, -1.05344954667372501984066689879e+1L,
             -2.00087205822486249909675718444L, -1.79589318631187989172765950534e+1L,
             2.79488845294199600508499808837e+1L, -2.85899827713502369474065508674L, -8.87285693353062954433549289258L,
             1.23605671757943030647266201528e+1L, 6.43392746015763530355970484046e-1L}},
      .b = {5.42937341165687622380535766363e-2L, 0.0L, 0.0L, 0.0L, 0.0L, 4.45031289275240888144113950566L,
            1.89151789931450038304281599044L, -5.8012039600105847814672114227L, 3.1116436695781989440891606237e-1L,
            -1.52160949662516078556178806805e-1L, 2.01365400804030348374776537501e-1L,
            4.47106157277725905176885569043e-2L},
      .error = {0.1312004499419488073250102996e-01L, 0.0L, 0.0L, 0.0L, 0.0L, -0.1225156446376204440720569753e+01L,
                -0.4957589496572501915214079952L, 0.1664377182454986536961530415e+01L, -0.3503288487499736816886487290L,
                0.3341791187130174790297318841L, 0.8192320648511571246570742613e-01L,
                -0.2235530786388629525884427845e-01L},
  };
}

DenseTableau dop853Dense() {
  return {
      .c = {0.1L, 0.2L, 0.777777777777777777777777777778L},
      .a = {{5.61675022830479523392909219681e-2L, 0.0L, 0.0L, 0.0L, 0.0L, 0.0L, 2.53500210216624811088794765333e-1L,
             -2.46239037470802489917441475441e-1L, -1.24191423263816360469010140626e-1L,
             1.5329179827876569731206322685e-1L, 8.20105229563468988491666602057e-3L,
             7.56789766054569976138603589584e-3L, -8.298e-3L},
            {3.18346481635021405060768473261e-2L, 0.0L, 0.0L, 0.0L, 0.0L, 2.83009096723667755288322961402e-2L,
             5.35419883074385676223797384372e-2L, -5.49237485713909884646569340306e-2L, 0.0L, 0.0L,
             -1.08347328697249322858509316994e-4L, 3.82571090835658412954920192323e-4L,
             -3.40465008687404560802977114492e-4L, 1.41312443674632500278074618366e-1L},
            {-4.28896301583791923408573538692e-1L, 0.0L, 0.0L, 0.0L, 0.0L, -4.69762141536116384314449447206L,
             7.68342119606259904184240953878L, 4.06898981839711007970213554331L, 3.56727187455281109270669543021e-1L,
             0.0L, 0.0L, 0.0L, -1.39902416515901462129418009734e-3L, 2.9475147891527723389556272149L,
             -9.15095847217987001081870187138L}},
      .d = {{-0.84289382761090128651353491142e+01L, 0.0L, 0.0L, 0.0L, 0.0L, 0.56671495351937776962531783590L,
             -0.30689499459498916912797304727e+01L, 0.23846676565120698287728149680e+01L,
             0.21170345824450282767155149946e+01L, -0.87139158377797299206789907490L,
             0.22404374302607882758541771650e+01L, 0.63157877876946881815570249290L,
             -0.88990336451333310820698117400e-01L, 0.18148505520854727256656404962e+02L,
             -0.91946323924783554000451984436e+01L, -0.44360363875948939664310572000e+01L},
            {0.10427508642579134603413151009e+02L, 0.0L, 0.0L, 0.0L, 0.0L, 0.24228349177525818288430175319e+03L,
             0.16520045171727028198505394887e+03L, -0.37454675472269020279518312152e+03L,
             -0.22113666853125306036270938578e+02L, 0.77334326684722638389603898808e+01L,
             -0.30674084731089398182061213626e+02L, -0.93321305264302278729567221706e+01L,
             0.15697238121770843886131091075e+02L, -0.31139403219565177677282850411e+02L,
             -0.93529243588444783865713862664e+01L, 0.35816841486394083752465898540e+02L},
            {0.19985053242002433820987653617e+02L, 0.0L, 0.0L, 0.0L, 0.0L, -0.38703730874935176555105901742e+03L,
             -0.18917813819516756882830838328e+03L, 0.52780815920542364900561016686e+03L,
             -0.11573902539959630126141871134e+02L, 0.68812326946963000169666922661e+01L,
             -0.10006050966910838403183860980e+01L, 0.77771377980534432092869265740L,
             -0.27782057523535084065932004339e+01L, -0.60196695231264120758267380846e+02L,
             0.84320405506677161018159903784e+02L, 0.11992291136182789328035130030e+02L},
            {-0.25693933462703749003312586129e+02L, 0.0L, 0.0L, 0.0L, 0.0L, -0.15418974869023643374053993627e+03L,
             -0.23152937917604549567536039109e+03L, 0.35763911791061412378285349910e+03L,
             0.93405324183624310003907691704e+02L, -0.37458323136451633156875139351e+02L,
             0.10409964950896230045147246184e+03L, 0.29840293426660503123344363579e+02L,
             -0.43533456590011143754432175058e+02L, 0.96324553959188282948394950600e+02L,
             -0.39177261675615439165231486172e+02L, -0.14972683625798562581422125276e+03L}},
  };
}

std::unique_ptr<Integrator> dop853() {
  static const StagePlan plan(dop853Info(), dop853Tableau(), toThird());
  return std::make_unique<DormandPrince853>(plan);
}

}  // namespace muelle::engine
