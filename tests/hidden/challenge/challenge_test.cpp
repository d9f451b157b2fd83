#include "challenge.h"

#include "course/testing/expect.h"
#include "low_order.h"
#include "trials.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

using muelle::Random;
using muelle::testRandom;
using namespace trials;

namespace {

constexpr double farAway = 20;  ///< [m] nothing that moves as it should comes near it

template <class Trial>
class Judgement {
 public:
  using Scene = typename Trial::Scene;

  Judgement() : numbers_(drawn()), asked_(Trial::sceneOf(numbers_)), right_(Trial::right(asked_.scene())) {}

  /// One run of the submission, with at most so many evaluations.
  void expectWithin(long band) {
    try {
      end_ = Trial::submitted(asked_);
    } catch (...) {
      noteSeen(whyStopped());
      throw;
    }
    const double error = distance(end_, right_);
    const long asked = asked_.tally().evaluations();
    if (!(error <= Scene::goal.error)) {
      noteSeen(whyInexact());
    } else if (asked > band) {
      noteSeen("asked_too_often");
    }
    if (error <= Scene::goal.error && band == Scene::goal.enough) expectTheSameAgain();
    {
      MUELLE_LABEL("how many coordinates are returned");
      EXPECT_NUMBER_NEAR(static_cast<double>(end_.size()), static_cast<double>(right_.size()), 0);
    }
    {
      MUELLE_LABEL(fmt::format("largest error of a coordinate at the end, after {} evaluations", asked), "m");
      EXPECT_NUMBER_NEAR(error, 0, Scene::goal.error);
    }
    MUELLE_LABEL(fmt::format("evaluations beyond the {} that this band allows; you ask for {}", band, asked));
    EXPECT_NUMBER_NEAR(static_cast<double>(std::max(0L, asked - band)), 0, 0);
  }

 private:
  static auto drawn() {
    Random random = testRandom();
    return Trial::numbersFrom(random);
  }

  /// A method that keeps something between its calls is right once.
  void expectTheSameAgain() {
    Asked<Scene> again(Trial::sceneOf(numbers_));
    const double difference = distance(Trial::submitted(again), end_);
    if (difference > 0) noteSeen("kept_between_calls");
    MUELLE_LABEL("largest difference between the ends of two runs of the same scene", "m");
    EXPECT_NUMBER_NEAR(difference, 0, 0);
  }

  static void noteSeen(const std::string& id) { muelle::grader::noteSeen(Trial::function, id); }

  /// That it grew before it was no number any more is the cause; else something was divided by zero.
  std::string whyLost() const {
    scenes::Tally seen = asked_.tally();
    seen.lookAt(end_);
    if (seen.farthest >= farAway) return "grows_without_bound";
    return seen.hasLostNumbers ? "no_number" : "";
  }

  std::string whyStopped() const {
    if (const std::string lost = whyLost(); !lost.empty()) return lost;
    return asked_.tally().evaluations() > Scene::goal.enough ? "asked_for_ever" : "";
  }

  /// Whether the submission ends where somebody ends who makes this mistake.
  bool isLike(const VecX& mistaken) const { return distance(end_, mistaken) < 1e-3 * distance(end_, right_); }

  /// Largest of a coordinate [m]; not a number where there are not as many.
  static double distance(const VecX& a, const VecX& b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::quiet_NaN();
    return (a - b).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }

  std::string whyInexact() const {
    if (end_.size() != right_.size()) return "";
    if (const std::string lost = whyLost(); !lost.empty()) return lost;
    if (asked_.tally().evaluations() == 0) return "asked_nothing";
    if (isWithoutDraught()) return "draught_left_out";
    const long steps = asked_.tally().forces;
    if (steps > 0 && isLike(endBy(low_order::explicitEuler, steps))) return "explicit_euler";
    if (steps > 0 && isLike(endBy(low_order::symplecticEuler, steps))) return "symplectic_euler";
    if (isBackwardEuler()) return "backward_euler";
    return isOfAnotherTime() ? "another_time" : "too_inexact";
  }

  /// What a method makes of the scene in so many steps.
  template <class Method, class... More>
  auto endBy(const Method& method, long steps, const More&... more) const {
    const Scene& scene = asked_.scene();
    return method(Trial::unlimited(scene), scene.masses(), scene.positions(), scene.velocities(), Scene::duration,
                  steps, more...);
  }

  bool isWithoutDraught() const {
    auto still = numbers_;
    still.draught = {};
    const VecX private_ = Trial::right(Trial::sceneOf(still));
    return distance(end_, private_) < 0.2 * distance(right_, private_);
  }

  bool isBackwardEuler() const {
    if constexpr (std::is_same_v<Scene, scenes::Cloth>) {
      const long steps = asked_.tally().hessians;
      const Hessian hessian = [&](double t, const VecX& x) { return asked_.scene().hessian(t, x); };
      const auto method = [&](const Force& force, const auto&... rest) {
        return low_order::backwardEuler(force, hessian, rest...);
      };
      return steps > 0 && isLike(endBy(method, steps));
    }
    return false;
  }

  bool isOfAnotherTime() const {
    return endBy(low_order::nearestDistance, Scene::goal.good, end_) < 0.02 * distance(end_, right_);
  }

  decltype(drawn()) numbers_;
  Asked<Scene> asked_;
  VecX right_, end_;
};

constexpr scenes::Goal rabbit = scenes::Rabbit::goal, cloth = scenes::Cloth::goal, ball = scenes::Ball::goal;

}  // namespace

// The bands are derived in tests/challenge from what reference methods need.

TEST(RabbitEnough, IsReached) {
  MUELLE_PROPERTY("the squeezed rabbit ends within 1e-7 m, for at most 3000 evaluations");
  Judgement<RabbitTrial>().expectWithin(rabbit.enough);
}

TEST(RabbitGood, IsReached) {
  MUELLE_PROPERTY("the squeezed rabbit ends within 1e-7 m, for at most 1200 evaluations");
  Judgement<RabbitTrial>().expectWithin(rabbit.good);
}

TEST(RabbitBest, IsReached) {
  MUELLE_PROPERTY("the squeezed rabbit ends within 1e-7 m, for at most 500 evaluations");
  Judgement<RabbitTrial>().expectWithin(rabbit.best);
}

TEST(ClothEnough, IsReached) {
  MUELLE_PROPERTY("the stiff cloth ends within 2e-4 m, for at most 12000 evaluations");
  Judgement<ClothTrial>().expectWithin(cloth.enough);
}

TEST(ClothGood, IsReached) {
  MUELLE_PROPERTY("the stiff cloth ends within 2e-4 m, for at most 7000 evaluations");
  Judgement<ClothTrial>().expectWithin(cloth.good);
}

TEST(ClothBest, IsReached) {
  MUELLE_PROPERTY("the stiff cloth ends within 2e-4 m, for at most 1400 evaluations");
  Judgement<ClothTrial>().expectWithin(cloth.best);
}

TEST(BallEnough, IsReached) {
  MUELLE_PROPERTY("the bouncing ball ends within 2e-3 m, for at most 40000 evaluations");
  Judgement<BallTrial>().expectWithin(ball.enough);
}

TEST(BallGood, IsReached) {
  MUELLE_PROPERTY("the bouncing ball ends within 2e-3 m, for at most 20000 evaluations");
  Judgement<BallTrial>().expectWithin(ball.good);
}

TEST(BallBest, IsReached) {
  MUELLE_PROPERTY("the bouncing ball ends within 2e-3 m, for at most 1600 evaluations");
  Judgement<BallTrial>().expectWithin(ball.best);
}
