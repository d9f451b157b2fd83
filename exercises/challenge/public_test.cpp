#include "challenge.h"
#include "course/testing/expect.h"
#include "judge.h"
#include "public_ends.h"

#include <gtest/gtest.h>

// The public scenes, judged as the hidden ones are, but by some nodes alone.

namespace {

using scenes::Asked;
using scenes::End;
using scenes::Goal;

/// One run, made once for all tests of a scene.
struct Run {
  VecX end;
  long evaluations = 0;
};

Run rabbitRun() {
  const Asked asked(scenes::Rabbit({}, scenes::rabbitMesh()));
  const auto& scene = asked.scene();
  const VecX end = submission::squeezedRabbit(asked.force(), scene.masses(), scene.positions(), scene.velocities());
  return {end, asked.tally().evaluations()};
}

Run clothRun() {
  const Asked asked(scenes::Cloth{});
  const auto& scene = asked.scene();
  const VecX end =
      submission::stiffCloth(asked.force(), asked.hessian(), scene.masses(), scene.positions(), scene.velocities());
  return {end, asked.tally().evaluations()};
}

Run ballRun() {
  const Asked asked(scenes::Ball{});
  const auto& scene = asked.scene();
  const VecX end = submission::bouncingBall(asked.force(), scene.masses(), scene.positions(), scene.velocities());
  return {end, asked.tally().evaluations()};
}

void expectWithin(const Run& run, const std::vector<End>& ends, std::size_t nodes, double error, long band) {
  {
    MUELLE_LABEL("how many coordinates are returned");
    ASSERT_NUMBER_NEAR(static_cast<double>(run.end.size()), 3 * static_cast<double>(nodes), 0);
  }
  for (const End& each : ends) {
    MUELLE_LABEL("where node " + std::to_string(each.node) + " is at the end", "m");
    EXPECT_VECTOR_NEAR(VecX(scenes::nodeOf(run.end, each.node)), VecX(each.x), error);
  }
  MUELLE_LABEL("evaluations beyond the " + std::to_string(band) + " that this band allows; you ask for " +
               std::to_string(run.evaluations));
  EXPECT_NUMBER_NEAR(static_cast<double>(std::max(0L, run.evaluations - band)), 0, 0);
}

constexpr Goal rabbit = scenes::Rabbit::goal, cloth = scenes::Cloth::goal, ball = scenes::Ball::goal;

TEST(RabbitEnough, IsReached) {
  MUELLE_PROPERTY("the squeezed rabbit ends within 1e-7 m, for at most 3000 evaluations");
  expectWithin(rabbitRun(), scenes::rabbitEnds, 2054, rabbit.error, rabbit.enough);
}

TEST(RabbitGood, IsReached) {
  MUELLE_PROPERTY("the squeezed rabbit ends within 1e-7 m, for at most 1200 evaluations");
  expectWithin(rabbitRun(), scenes::rabbitEnds, 2054, rabbit.error, rabbit.good);
}

TEST(RabbitBest, IsReached) {
  MUELLE_PROPERTY("the squeezed rabbit ends within 1e-7 m, for at most 500 evaluations");
  expectWithin(rabbitRun(), scenes::rabbitEnds, 2054, rabbit.error, rabbit.best);
}

TEST(ClothEnough, IsReached) {
  MUELLE_PROPERTY("the stiff cloth ends within 2e-4 m, for at most 12000 evaluations");
  expectWithin(clothRun(), scenes::clothEnds, 100, cloth.error, cloth.enough);
}

TEST(ClothGood, IsReached) {
  MUELLE_PROPERTY("the stiff cloth ends within 2e-4 m, for at most 7000 evaluations");
  expectWithin(clothRun(), scenes::clothEnds, 100, cloth.error, cloth.good);
}

TEST(ClothBest, IsReached) {
  MUELLE_PROPERTY("the stiff cloth ends within 2e-4 m, for at most 1400 evaluations");
  expectWithin(clothRun(), scenes::clothEnds, 100, cloth.error, cloth.best);
}

TEST(BallEnough, IsReached) {
  MUELLE_PROPERTY("the bouncing ball ends within 2e-3 m, for at most 40000 evaluations");
  expectWithin(ballRun(), scenes::ballEnds, 1, ball.error, ball.enough);
}

TEST(BallGood, IsReached) {
  MUELLE_PROPERTY("the bouncing ball ends within 2e-3 m, for at most 20000 evaluations");
  expectWithin(ballRun(), scenes::ballEnds, 1, ball.error, ball.good);
}

TEST(BallBest, IsReached) {
  MUELLE_PROPERTY("the bouncing ball ends within 2e-3 m, for at most 1600 evaluations");
  expectWithin(ballRun(), scenes::ballEnds, 1, ball.error, ball.best);
}

}  // namespace
