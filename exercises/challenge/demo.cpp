#include "harness/demo.h"
#include "challenge.h"
#include "frontier.h"
#include "judge.h"
#include "public_ends.h"

// The public scenes with your functions: your error and your evaluations among those of other methods, and where you
// have asked for the force.

namespace {

using scenes::Asked;

/// What a run has come to.
struct Run {
  double error = NAN;  ///< [m]
  double evaluations = NAN;
  std::vector<double> times, heights;  ///< of the last node, where the force was asked
};

double errorOf(const VecX& end, const std::vector<scenes::End>& right) {
  double error = 0;
  for (const scenes::End& each : right) {
    if (end.size() < scenes::place(each.node + 1)) return NAN;
    error = std::max(error, (scenes::nodeOf(end, each.node) - each.x).cwiseAbs().maxCoeff());
  }
  return error;
}

/// Runs a function; of one that asks for ever nothing is drawn but where it has asked.
template <class Scene, class Function>
Run runOf(const Scene& scene, const std::vector<scenes::End>& right, const Function& function) {
  const Asked asked(scene);
  Run run;
  const Force force = [&run, ask = asked.force()](double t, const VecX& x, const VecX& v) {
    run.times.push_back(t);
    run.heights.push_back(x.size() == 0 ? NAN : x[x.size() - 1]);
    return ask(t, x, v);
  };
  try {
    run.error = errorOf(function(force, asked), right);
    run.evaluations = static_cast<double>(asked.tally().evaluations());
  } catch (const muelle::BadQuestion&) {
  }
  return run;
}

Run rabbitRun() {
  const scenes::Rabbit scene({}, scenes::rabbitMesh());
  return runOf(scene, scenes::rabbitEnds, [&](const Force& force, const auto&) {
    return submission::squeezedRabbit(force, scene.masses(), scene.positions(), scene.velocities());
  });
}

Run clothRun() {
  const scenes::Cloth scene;
  return runOf(scene, scenes::clothEnds, [&](const Force& force, const auto& asked) {
    return submission::stiffCloth(force, asked.hessian(), scene.masses(), scene.positions(), scene.velocities());
  });
}

Run ballRun() {
  const scenes::Ball scene;
  return runOf(scene, scenes::ballEnds, [&](const Force& force, const auto&) {
    return submission::bouncingBall(force, scene.masses(), scene.positions(), scene.velocities());
  });
}

/// The steps that lead down to the goal: what lies below the line and to the left of a step is in its band.
void drawBands(muelle::Figure::PanelBuilder& panel, const scenes::Goal& goal, double lowest) {
  const double left = 100;
  panel.structure("error allowed", {left, static_cast<double>(goal.enough)}, {goal.error, goal.error});
  for (const long band : {goal.best, goal.good, goal.enough}) {
    const auto x = static_cast<double>(band);
    panel.structure(band == goal.best ? "ends of the bands" : "", {x, x}, {lowest, goal.error});
  }
}

muelle::Figure workPrecision(const char* id, const char* title, const std::vector<scenes::Curve>& curves,
                             const scenes::Goal& goal, const Run& run) {
  muelle::Figure figure(id, title, "evaluations of the force");
  figure.logX();
  auto panel = figure.panel("largest error at the end [m]");
  panel.logY();
  double lowest = goal.error;
  for (const scenes::Curve& curve : curves) {
    std::vector<double> x, y;
    for (const scenes::Point& point : curve.points) {
      x.push_back(static_cast<double>(point.evaluations));
      y.push_back(point.error);
      lowest = std::min(lowest, point.error);
    }
    panel.linePoints(curve.name, x, y);
  }
  drawBands(panel, goal, lowest);
  panel.points("your function", {run.evaluations}, {run.error});
  return figure;
}

/// Every so many questions, so that at most a thousand are drawn.
muelle::Figure questions(const char* id, const char* title, const char* label, const Run& run) {
  muelle::Figure figure(id, title, "time [s]");
  std::vector<double> t, z;
  const std::size_t each = run.times.size() / 1000 + 1;
  for (std::size_t i = 0; i < run.times.size(); i += each) {
    t.push_back(run.times[i]);
    z.push_back(run.heights[i]);
  }
  auto panel = figure.panel(label);
  panel.expect(-1.0, 1.2);
  panel.points("where the force was asked", t, z);
  return figure;
}

}  // namespace

MUELLE_DEMO {
  const Run rabbit = rabbitRun(), cloth = clothRun(), ball = ballRun();
  return {workPrecision("rabbit", "Error and work: the squeezed rabbit", scenes::rabbitFrontier, scenes::Rabbit::goal,
                        rabbit),
          workPrecision("cloth", "Error and work: the stiff cloth", scenes::clothFrontier, scenes::Cloth::goal, cloth),
          workPrecision("ball", "Error and work: the bouncing ball", scenes::ballFrontier, scenes::Ball::goal, ball),
          questions("questions_of_the_ball", "Where the force of the ball was asked", "height of the ball [m]", ball)};
}
