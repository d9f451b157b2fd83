#include "engine/model/singular_points.h"

#include <gtest/gtest.h>
#include <cmath>

namespace muelle::engine {
namespace {

Model withNodes(std::initializer_list<Vec3> places, int dimension = 3) {
  Model model;
  model.dimension = dimension;
  for (const Vec3& place : places) model.nodes.push_back({.x = place});
  return model;
}

Model pair(double L0) {
  Model model = withNodes({Vec3(1, 2, 3), Vec3(1, 2, 3)});
  model.springs.push_back({.a = 0, .b = 1, .k = 10.0, .L0 = L0});
  return model;
}

Model angle(const Vec3& end, double theta0, int dimension = 3) {
  Model model = withNodes({Vec3(0, 0, 0), Vec3(1, 0, 0), end}, dimension);
  model.angles.push_back({.k = 1.0, .theta0 = theta0});
  return model;
}

Model dihedral(const Vec3& c, const Vec3& d) {
  Model model = withNodes({Vec3(0, 0, 0), Vec3(1, 0, 0), c, d});
  model.dihedrals.push_back({.k = 1.0, .theta0 = 0.2});
  return model;
}

Model inside(Obstacle::Kind kind, const Vec3& place) {
  Model model = withNodes({place});
  model.obstacles.push_back({.kind = kind, .name = "ball", .centre = Vec3(0, 0, 1), .halfSize = Vec3(1.0, 2.0, 3.0)});
  return model;
}

std::vector<SingularPoint> pointsOf(const Model& model) {
  const auto system = build(model);
  return singularPoints(*system, system->initialState());
}

std::string described(const Model& model) {
  std::string text;
  for (const SingularPoint& point : pointsOf(model)) text += point.what;
  return text;
}

/// The largest change of a force [N] between two places on either side of the start, `distance` [m] away from it.
double jump(const Model& model, double distance) {
  const auto system = build(model);
  const State start = system->initialState();
  std::vector<double> forces[2];
  for (int side = 0; side < 2; ++side) {
    State moved = start;
    for (std::size_t i = 0; i < moved.x.size(); ++i) {
      // Directions without a pattern, so that no two neighbours move alike.
      if (system->inverseMass()[i] > 0.0)
        moved.x[i] += (side == 0 ? distance : -distance) * std::sin(12.9898 * static_cast<double>(i) + 0.7);
    }
    forces[side].resize(moved.x.size());
    system->force(moved.t, moved.x, moved.v, moved.z, forces[side]);
  }
  double largest = 0.0;
  for (std::size_t i = 0; i < forces[0].size(); ++i) largest = std::max(largest, std::abs(forces[0][i] - forces[1][i]));
  return largest;
}

const Model singular[] = {
    pair(0.5),
    angle({2, 0, 0}, 0.3),
    angle({0.5, 0, 0}, 0.0),
    angle({0.5, 0, 0}, 0.3, 2),
    angle({1, 0, 0}, 0.3),
    dihedral({0.3, 1, 0}, {0.4, 1, 0}),
    dihedral({0.3, 1, 0}, {0.4, 0, 0}),
    inside(Obstacle::Kind::Sphere, {0, 0, 1}),
};

const Model smooth[] = {
    pair(0.0),                            // a spring of rest length 0
    angle({2, 0, 0}, 0.0),                // straight is where it wants to be
    angle({2, 0, 0}, 0.3, 2),             // in the plane an angle has a sign
    dihedral({0.3, 1, 0}, {0.4, -1, 0}),  // flat
    inside(Obstacle::Kind::Sphere, {0, 0, 1.5}),
    inside(Obstacle::Kind::Box, {0, 0.5, 1.5}),  // the face is that of the start
};

TEST(SingularPoints, AreNamed) {
  EXPECT_EQ(described(pair(0.5)),
            "nodes 0 and 1 lie in one place, and spring 0 between them is 0.5 m long: its force has no direction "
            "there");
  EXPECT_EQ(described(angle({2, 0, 0}, 0.3)),
            "angle 0 at node 1 is straight and wants 0.3 rad: it has no side to bend to");
  EXPECT_EQ(described(angle({0.5, 0, 0}, 0.0)),
            "angle 0 at node 1 is folded back onto itself: it has no side to open to");
  EXPECT_EQ(described(angle({1, 0, 0}, 0.3)), "angle 0 at node 1 has an edge without length: it is no angle");
  EXPECT_EQ(described(dihedral({0.3, 1, 0}, {0.4, 1, 0})),
            "dihedral 0 at the edge of nodes 0 and 1 is folded back onto itself: it has no side to open to");
  EXPECT_EQ(described(dihedral({0.3, 1, 0}, {0.4, 0, 0})),
            "dihedral 0 at the edge of nodes 0 and 1 has a triangle without area: it is no angle");
  EXPECT_EQ(described(inside(Obstacle::Kind::Sphere, {0, 0, 1})),
            "node 0 lies at the centre of 'ball', which has no side to push it out of");
}

/// Where the energy has a gradient the change falls with the distance (a thousandfold here); where it has none it stays
/// (or, where a length vanishes, grows).
TEST(SingularPoints, AreWhereTheForceDependsOnTheWayThere) {
  for (const Model& model : singular) {
    EXPECT_EQ(pointsOf(model).size(), 1U) << described(model);
    EXPECT_GT(jump(model, 1e-6), 0.5 * jump(model, 1e-3)) << described(model);
  }
  for (const Model& model : smooth) {
    EXPECT_TRUE(pointsOf(model).empty()) << described(model);
    EXPECT_LT(jump(model, 1e-6), 2e-3 * jump(model, 1e-3));
  }
}

TEST(SingularPoints, TakeNodesThatMoveOnly) {
  Model held = pair(0.5);
  held.nodes[0].pinned = true;
  EXPECT_EQ(pointsOf(held).at(0).nodes, std::vector<int>{1});
  held.nodes[1].pinned = true;
  held.nodes.push_back({.x = Vec3(5, 5, 5)});
  EXPECT_TRUE(pointsOf(held).empty());
}

TEST(SingularPoints, KnowOnlyTheComponentsOfTheScene) {
  Model disc = inside(Obstacle::Kind::Sphere, {0, 7, 1});
  disc.dimension = 2;
  disc.plane = {0, 2};
  disc.obstacles[0].centre = {0, -3, 1};
  EXPECT_EQ(pointsOf(disc).size(), 1U);
}

TEST(SingularPoints, MoveWithTheirObstacleUntilItStops) {
  Model model = inside(Obstacle::Kind::Sphere, {0, 0, 1.5});
  model.obstacles[0].velocity = {0, 0, 1.0};
  model.obstacles[0].stopTime = 0.5;
  const std::vector<Vec3> places = {model.nodes[0].x};
  EXPECT_TRUE(singularPoints(model, places, 0.25).empty());
  EXPECT_EQ(singularPoints(model, places, 0.5).size(), 1U);
  EXPECT_EQ(singularPoints(model, places, 2.0).size(), 1U);
}

}  // namespace
}  // namespace muelle::engine
