#pragma once
#include "engine/dynamical_system.h"
#include "engine/solve/linear_solver.h"
#include "engine/work.h"

#include <array>
#include <Eigen/Core>
#include <functional>
#include <string>

namespace muelle::engine {

/// One implicit equation for a velocity increment w [m/s],
///
///     M w = g + tau F(t, X, V),   X = X0 + alpha w,   V = V0 + beta w,
///
/// with the Jacobian M + tau beta D + tau alpha K. Each stage of the implicit methods has this form.
struct ImplicitStage {
  double t = 0.0;
  double tau = 0.0, alpha = 0.0, beta = 0.0;  ///< [s], [s], dimensionless
  Eigen::VectorXd X0, V0;                     ///< [m], [m/s]
  Eigen::VectorXd g;                          ///< [N s]; empty: zero
  In z;
  /// Replaces F when set (a discrete gradient); the Jacobian at (t, X, V) is then an approximation: where it does not
  /// suffice, it becomes the preconditioner of GMRES on differences of the residual (Knoll, Keyes 2004).
  std::function<void(const Eigen::VectorXd& w, const Eigen::VectorXd& X, const Eigen::VectorXd& V, Eigen::VectorXd& F)>
      force;
  int forceCost = 1;  ///< force evaluations that `force` is worth
};

struct NewtonOptions {
  double tolerance =
      1e-12;  ///< of each unknown's residual, relative to the terms |M w| + tau |F| + |g| of its equation
  int mostIterations = 200;
  bool polish = false;      ///< go on, with the last matrix, until the residual falls no further
  bool reuse = false;       ///< begin with the last solve's matrix (of a stage with the same factors), while it is good
  bool simplified = false;  ///< keep each matrix as long as the residual at least halves with it
};

struct NewtonReport {
  bool done = false;
  int iterations = 0;
  double residual = 0.0;  ///< largest relative residual at the end
  std::string failure;    ///< one line when not done
};

/// Newton's method with a line search for implicit stages.
///
/// Where a potential exists the search follows the incremental potential
///
///     Phi(w) = w^T M w / 2 - g^T w + (tau / alpha) E(X) - tau F_rest^T w,
///
/// whose gradient is the true residual; F_rest, the forces without potential (damping, friction), is taken as constant
/// in the search alone. Directions come from the energy's Hessian while it is positive definite, else from the
/// projected one, so that saddles are left (a search on the residual would stall there). When the damping's dependence
/// on positions makes this slow, the exact, non-symmetric Jacobian takes over. Without a potential the exact Jacobian
/// is used throughout and the search follows the residual.
///
/// It stops by the true residual, never by a step or a projected matrix. Where round-off keeps the residual above the
/// tolerance (|J| (|X| / alpha + |V| / beta) eps, what the last bits of the state do) the stage counts as solved at
/// that floor.
class Newton {
 public:
  /// Allocates for the system; throws std::invalid_argument when it has no linearisation.
  void prepare(const DynamicalSystem& system);
  /// Solves from the guess in w and leaves the solution there.
  NewtonReport solve(const DynamicalSystem& system, const ImplicitStage& stage, const NewtonOptions& options,
                     Eigen::VectorXd& w, Work& work);
  /// Whether the last solve() had a matrix: it has none where its guess was the solution to the last bit.
  bool hasMatrix() const { return hasMatrix_; }
  /// x = J^-1 b with the last matrix of the last solve(), one near its solution; false when that has none.
  bool solveWithLastMatrix(const Eigen::VectorXd& b, Eigen::VectorXd& x, Work& work);
  /// X, V and F at the solution of the last solve().
  const Eigen::VectorXd& position() const { return here_.X; }
  const Eigen::VectorXd& velocity() const { return here_.V; }
  const Eigen::VectorXd& force() const { return here_.F; }

 private:
  struct Point {
    Eigen::VectorXd w, X, V, F, R;
    double size = 0.0;  ///< |R| in the norm of M^-1
    bool finite = false;
  };
  enum class Search { Accepted, Failed };

  void evaluate(const Eigen::VectorXd& w, Point& point);
  double energy(const Point& point);
  /// Largest residual over its terms, less the floor of round-off. `worst` is the unknown that has it.
  double relativeResidual(const Point& point, double floorFactor, int& worst) const;
  bool atFloor(const Point& point, double factor);
  bool factorise(Form form, Factorisation& found);
  bool direction(std::string& failure);
  bool newDirection(Form form, std::string& failure);
  bool krylovDirection();
  Search searchEnergy(double slope);
  Search searchResidual();
  Search searchKrylov(Search found);
  /// Whether the search follows the incremental potential; else the residual.
  bool followsPotential() const { return system_->potential() != nullptr && !stage_->force; }
  std::string setOut(Eigen::VectorXd& w);
  bool downhill(std::string& failure);
  Search search();
  std::string iterate(const NewtonOptions& options, int& iterations);
  /// Computes floor_ for the last matrix, once.
  void needFloor();
  void keepMatrix();
  int reuseMatrix(double tolerance);
  /// Whether the residual is within the tolerance, or as low as round-off lets it be; sets relative_.
  bool converged(double tolerance, int& worst);

  const DynamicalSystem* system_ = nullptr;
  const ImplicitStage* stage_ = nullptr;
  Work* work_ = nullptr;
  Eigen::Map<const Eigen::VectorXd> mass_{nullptr, 0};
  LinearSolver solver_;
  SystemMatrix J_;
  Point here_, trial_;
  Point probe_;  ///< beside here_, for GMRES's differences
  Eigen::VectorXd step_, rest_, floor_, absolute_, scratch_;
  double relative_ = 0.0;
  Form form_ = Form::Exact;  ///< of the matrix that the next direction is asked of
  bool exactWorks_ = true;   ///< the exact matrix has given no direction that climbs
  bool floorKnown_ = false;
  bool hasMatrix_ = false;
  std::array<double, 3> factors_{};  ///< tau, alpha, beta of the last matrix
};

}  // namespace muelle::engine
