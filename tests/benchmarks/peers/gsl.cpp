#include "gsl.h"

#include "problem.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_version.h>
#include <memory>

namespace muelle::bench {

namespace {

template <class Problem>
class Gsl : public PeerContestant<Problem> {
 public:
  Gsl(const Problem& problem, const char* name, const gsl_odeiv2_step_type* type)
      : PeerContestant<Problem>(problem, "gsl", name), type_(type) {
    gsl_set_error_handler_off();
  }
  bool takesTolerance() const override { return true; }
  bool mayJudge() const override { return this->method() == "rk8pd" && this->row() == Row::Plain; }

 protected:
  std::string solve(double setting, Path* path) override {
    std::vector<double> y = this->start();
    const double end = this->duration();
    const bool needsMatrix = type_ == gsl_odeiv2_step_msbdf;
    gsl_odeiv2_system system = {slopeOf, needsMatrix ? jacobianOf : nullptr, y.size(), this};
    // The driver's limits of order 1e-15 are below what a step of multistep methods can be asked for.
    const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, type_, 1e-4 * end, setting, setting), gsl_odeiv2_driver_free);
    double t = 0.0;
    while (t < end) {
      const int status =
          gsl_odeiv2_evolve_apply(driver->e, driver->c, driver->s, &system, &t, end, &driver->h, y.data());
      if (status != GSL_SUCCESS) return std::string(gsl_strerror(status)) + " at " + std::to_string(t) + " s";
      this->show(path, t, y.data(), y.data() + this->half());
      if (!std::isfinite(y[0]) || driver->h < 1e-18 * end) return this->blownUp(t);
      if (this->problem_.evaluations > mostEvaluations) return "too many evaluations";
    }
    return this->isFinite(y.data(), y.size()) ? "" : this->blownUp(t);
  }

 private:
  static int slopeOf(double t, const double* y, double* rate, void* self) {
    static_cast<Gsl*>(self)->slope(t, y, rate);
    return GSL_SUCCESS;
  }

  /// By central differences: a dense matrix of few unknowns.
  static int jacobianOf(double t, const double* y, double* dfdy, double* dfdt, void* self) {
    Gsl& gsl = *static_cast<Gsl*>(self);
    const std::size_t n = 2 * gsl.half();
    std::vector<double> at(y, y + n), above(n), below(n);
    for (std::size_t j = 0; j < n; ++j) {
      const double offset = 1e-6 * std::max(1.0, std::abs(y[j]));
      at[j] = y[j] + offset;
      gsl.slope(t, at.data(), above.data());
      at[j] = y[j] - offset;
      gsl.slope(t, at.data(), below.data());
      at[j] = y[j];
      for (std::size_t i = 0; i < n; ++i) dfdy[i * n + j] = (above[i] - below[i]) / (2.0 * offset);
    }
    std::fill(dfdt, dfdt + n, 0.0);
    ++gsl.jacobians_;
    return GSL_SUCCESS;
  }

  const gsl_odeiv2_step_type* type_;
};

}  // namespace

template <class Problem>
void addGsl(const Problem& problem, Contestants& all) {
  all.push_back(std::make_unique<Gsl<Problem>>(problem, "rk8pd", gsl_odeiv2_step_rk8pd));
  all.push_back(std::make_unique<Gsl<Problem>>(problem, "msadams", gsl_odeiv2_step_msadams));
  if (problem.size() <= 20) all.push_back(std::make_unique<Gsl<Problem>>(problem, "msbdf", gsl_odeiv2_step_msbdf));
}

template void addGsl(const PlainProblem<1>&, Contestants&);
template void addGsl(const PlainProblem<2>&, Contestants&);
template void addGsl(const PlainProblem<3>&, Contestants&);
template void addGsl(const KernelProblem&, Contestants&);

std::string gslVersion() { return "GSL " GSL_VERSION; }

}  // namespace muelle::bench
