#include "sundials.h"

#include "problem.h"
#include "sparse_fill.h"

#include <arkode/arkode_arkstep.h>
#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_version.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <memory>

namespace muelle::bench {

namespace {

constexpr long mostSteps = 100'000'000;

/// The objects of a run, freed with it.
struct Run {
  SUNContext context = nullptr;
  N_Vector y = nullptr;
  SUNMatrix matrix = nullptr;
  SUNLinearSolver linear = nullptr;
  SUNNonlinearSolver nonlinear = nullptr;

  explicit Run(const std::vector<double>& start) {
    SUNContext_Create(nullptr, &context);
    y = N_VNew_Serial(static_cast<sunindextype>(start.size()), context);
    std::copy(start.begin(), start.end(), N_VGetArrayPointer(y));
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  ~Run() {
    if (nonlinear != nullptr) SUNNonlinSolFree(nonlinear);
    if (linear != nullptr) SUNLinSolFree(linear);
    if (matrix != nullptr) SUNMatDestroy(matrix);
    N_VDestroy(y);
    SUNContext_Free(&context);
  }
  const double* values() const { return N_VGetArrayPointer(y); }
};

void ignoreMessages(int, const char*, const char*, char*, void*) {}

enum class Solver { CvodeAdams, CvodeBdf, Erk4, Erk8, Esdirk4 };

template <class Problem>
class Sundials : public PeerContestant<Problem> {
 public:
  Sundials(const Problem& problem, const char* name, Solver solver)
      : PeerContestant<Problem>(problem, "sundials", name), solver_(solver) {}
  bool takesTolerance() const override { return true; }

 protected:
  std::string solve(double setting, Path* path) override {
    Run run(this->start());
    if (solver_ == Solver::CvodeAdams || solver_ == Solver::CvodeBdf) return solveByCvode(run, setting, path);
    if (solver_ == Solver::Esdirk4) return solveByArkstep(run, setting, path);
    return solveByErkstep(run, setting, path);
  }

 private:
  std::string solveByCvode(Run& run, double tolerance, Path* path) {
    const std::unique_ptr<void, void (*)(void*)> memory(
        CVodeCreate(solver_ == Solver::CvodeBdf ? CV_BDF : CV_ADAMS, run.context), [](void* m) { CVodeFree(&m); });
    void* cvode = memory.get();
    CVodeInit(cvode, slopeOf, 0.0, run.y);
    CVodeSetErrHandlerFn(cvode, ignoreMessages, nullptr);
    CVodeSStolerances(cvode, tolerance, tolerance);
    CVodeSetUserData(cvode, this);
    CVodeSetMaxNumSteps(cvode, mostSteps);
    CVodeSetStopTime(cvode, this->duration());
    if (solver_ == Solver::CvodeBdf) {
      makeKlu(run);
      CVodeSetLinearSolver(cvode, run.linear, run.matrix);
      CVodeSetJacFn(cvode, jacobianOf);
    } else {
      run.nonlinear = SUNNonlinSol_FixedPoint(run.y, 0, run.context);
      CVodeSetNonlinearSolver(cvode, run.nonlinear);
    }
    return steps(run, path, [&](double& t) { return CVode(cvode, this->duration(), run.y, &t, CV_ONE_STEP); });
  }

  std::string solveByErkstep(Run& run, double tolerance, Path* path) {
    const std::unique_ptr<void, void (*)(void*)> memory(ERKStepCreate(slopeOf, 0.0, run.y, run.context),
                                                        [](void* m) { ERKStepFree(&m); });
    void* erk = memory.get();
    ERKStepSetErrHandlerFn(erk, ignoreMessages, nullptr);
    ERKStepSStolerances(erk, tolerance, tolerance);
    ERKStepSetUserData(erk, this);
    ERKStepSetOrder(erk, solver_ == Solver::Erk8 ? 8 : 4);
    ERKStepSetMaxNumSteps(erk, mostSteps);
    ERKStepSetStopTime(erk, this->duration());
    return steps(run, path, [&](double& t) { return ERKStepEvolve(erk, this->duration(), run.y, &t, ARK_ONE_STEP); });
  }

  std::string solveByArkstep(Run& run, double tolerance, Path* path) {
    const std::unique_ptr<void, void (*)(void*)> memory(ARKStepCreate(nullptr, slopeOf, 0.0, run.y, run.context),
                                                        [](void* m) { ARKStepFree(&m); });
    void* ark = memory.get();
    ARKStepSetErrHandlerFn(ark, ignoreMessages, nullptr);
    ARKStepSStolerances(ark, tolerance, tolerance);
    ARKStepSetUserData(ark, this);
    ARKStepSetOrder(ark, 4);
    ARKStepSetMaxNumSteps(ark, mostSteps);
    ARKStepSetStopTime(ark, this->duration());
    makeKlu(run);
    ARKStepSetLinearSolver(ark, run.linear, run.matrix);
    ARKStepSetJacFn(ark, jacobianOf);
    return steps(run, path, [&](double& t) { return ARKStepEvolve(ark, this->duration(), run.y, &t, ARK_ONE_STEP); });
  }

  template <class Step>
  std::string steps(Run& run, Path* path, Step step) {
    const double end = this->duration();
    double t = 0.0, before = -1.0;
    while (end - t > 1e-13 * end) {
      const int flag = step(t);
      if (flag < 0) return "SUNDIALS gives up (" + std::to_string(flag) + ") at " + std::to_string(t) + " s";
      if (t <= before) return "no progress at " + std::to_string(t) + " s";
      before = t;
      this->show(path, t, run.values(), run.values() + this->half());
      if (this->problem_.evaluations > mostEvaluations) return "too many evaluations";
    }
    return this->isFinite(run.values(), 2 * this->half()) ? "" : this->blownUp(t);
  }

  void makeKlu(Run& run) {
    const std::size_t n = 2 * this->half();
    if (!fill_.closed()) {
      const std::vector<double> y = this->start();
      this->problem_.jacobian(0.0, y.data(), y.data() + this->half(),
                              [&](std::size_t row, std::size_t column, double) { fill_.note(row, column); });
      fill_.close(n);
    }
    const auto size = static_cast<sunindextype>(n);
    run.matrix = SUNSparseMatrix(size, size, static_cast<sunindextype>(fill_.count()), CSC_MAT, run.context);
    fill_.begin(run.matrix);
    run.linear = SUNLinSol_KLU(run.y, run.matrix, run.context);
  }

  static int slopeOf(double t, N_Vector y, N_Vector rate, void* self) {
    auto& peer = *static_cast<Sundials*>(self);
    peer.slope(t, N_VGetArrayPointer(y), N_VGetArrayPointer(rate));
    return 0;
  }

  static int jacobianOf(double t, N_Vector y, N_Vector, SUNMatrix matrix, void* self, N_Vector, N_Vector, N_Vector) {
    auto& peer = *static_cast<Sundials*>(self);
    peer.fill_.begin(matrix);
    const double* values = N_VGetArrayPointer(y);
    peer.problem_.jacobian(t, values, values + peer.half(),
                           [&peer](std::size_t, std::size_t, double value) { peer.fill_.add(value); });
    ++peer.jacobians_;
    return 0;
  }

  Solver solver_;
  SparseFill fill_;
};

/// Two phases, in the air and on the ground; a root of x ends each.
class CvodeBall : public Contestant {
 public:
  explicit CvodeBall(const BenchScene& scene) : scene_(scene) {}
  Row row() const override { return Row::Plain; }
  std::string library() const override { return "sundials"; }
  std::string method() const override { return "cvode_adams_roots"; }
  bool takesTolerance() const override { return true; }
  bool locatesEvents() const override { return true; }

  RunCost run(double setting, Path* path) override {
    cost_ = {};
    touching_ = false;
    const engine::ModelNode& ball = scene_.model.nodes[0];
    gravity_ = scene_.model.gravity[0];
    stiffness_ = scene_.model.obstacles[0].material.k / ball.m;
    Run run({ball.x[0], ball.v[0]});
    const std::unique_ptr<void, void (*)(void*)> memory(CVodeCreate(CV_ADAMS, run.context),
                                                        [](void* m) { CVodeFree(&m); });
    void* cvode = memory.get();
    CVodeInit(cvode, slopeOf, 0.0, run.y);
    CVodeSetErrHandlerFn(cvode, ignoreMessages, nullptr);
    CVodeSStolerances(cvode, setting, setting);
    CVodeSetUserData(cvode, this);
    CVodeSetMaxNumSteps(cvode, mostSteps);
    CVodeSetStopTime(cvode, scene_.duration);
    run.nonlinear = SUNNonlinSol_FixedPoint(run.y, 0, run.context);
    CVodeSetNonlinearSolver(cvode, run.nonlinear);
    CVodeRootInit(cvode, 1, heightOf);
    advance(cvode, run, path);
    return cost_;
  }

 private:
  void advance(void* cvode, Run& run, Path* path) {
    double t = 0.0;
    while (scene_.duration - t > 1e-13 * scene_.duration) {
      const int flag = CVode(cvode, scene_.duration, run.y, &t, CV_ONE_STEP);
      if (flag < 0 || cost_.evaluations > mostEvaluations) {
        cost_.failure = "CVODE gives up (" + std::to_string(flag) + ") at " + std::to_string(t) + " s";
        return;
      }
      if (flag == CV_ROOT_RETURN) {
        touching_ = N_VGetArrayPointer(run.y)[1] < 0.0;
        CVodeReInit(cvode, t, run.y);
      }
      if (path != nullptr && path->wants(t)) path->see({t, {run.values()[0]}, {run.values()[1]}});
    }
  }

  static int slopeOf(double, N_Vector y, N_Vector rate, void* self) {
    auto& peer = *static_cast<CvodeBall*>(self);
    ++peer.cost_.evaluations;
    const double* values = N_VGetArrayPointer(y);
    N_VGetArrayPointer(rate)[0] = values[1];
    N_VGetArrayPointer(rate)[1] = peer.gravity_ - (peer.touching_ ? peer.stiffness_ * values[0] : 0.0);
    return 0;
  }
  static int heightOf(double, N_Vector y, double* height, void*) {
    *height = N_VGetArrayPointer(y)[0];
    return 0;
  }

  const BenchScene& scene_;
  RunCost cost_;
  bool touching_ = false;
  double gravity_ = 0.0, stiffness_ = 0.0;
};

}  // namespace

template <class Problem>
void addSundials(const Problem& problem, Contestants& all) {
  all.push_back(std::make_unique<Sundials<Problem>>(problem, "cvode_adams", Solver::CvodeAdams));
  all.push_back(std::make_unique<Sundials<Problem>>(problem, "cvode_bdf_klu", Solver::CvodeBdf));
  all.push_back(std::make_unique<Sundials<Problem>>(problem, "arkode_erk4", Solver::Erk4));
  all.push_back(std::make_unique<Sundials<Problem>>(problem, "arkode_erk8", Solver::Erk8));
  all.push_back(std::make_unique<Sundials<Problem>>(problem, "arkode_esdirk4_klu", Solver::Esdirk4));
}

template void addSundials(const PlainProblem<1>&, Contestants&);
template void addSundials(const PlainProblem<2>&, Contestants&);
template void addSundials(const PlainProblem<3>&, Contestants&);
template void addSundials(const KernelProblem&, Contestants&);

void addCvodeBall(const BenchScene& scene, Contestants& all) { all.push_back(std::make_unique<CvodeBall>(scene)); }

std::string sundialsVersion() { return "SUNDIALS " SUNDIALS_VERSION; }

}  // namespace muelle::bench
