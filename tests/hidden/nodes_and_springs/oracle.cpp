/// \file
/// The expected values without any object: sums over the springs by index.

#include "nodes_and_springs.h"

namespace {

std::size_t place(int i) { return static_cast<std::size_t>(i); }

}  // namespace

namespace oracle {

Vec3 getForce(const Vec3& xa, const Vec3& xb, double stiffness, double length, int end, const ForceLaw& law) {
  const Vec3 onA = law(xa, xb, stiffness, length);
  return end == 0 ? onA : Vec3(-onA);
}

Vec3 calcForce(const Vec3& xa, const Vec3& xb, double stiffness, double length, const ForceLaw& law) {
  return law(xa, xb, stiffness, length);
}

Vec3 calcAcceleration(double mass, const Vec3& F) { return (1 / mass) * F; }

std::vector<Result> gather(const std::vector<NodeData>& nodes, const std::vector<SpringData>& springs,
                           const ForceLaw& law) {
  std::vector<Result> results;
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    Vec3 F = Vec3::Zero();
    for (const SpringData& s : springs) {
      const Vec3& xa = nodes.at(place(s.a)).x;
      const Vec3& xb = nodes.at(place(s.b)).x;
      if (s.a == i) F += given::getForce(xa, xb, s.stiffness, s.length, 0, law);
      if (s.b == i) F += given::getForce(xa, xb, s.stiffness, s.length, 1, law);
    }
    results.push_back({F, given::calcAcceleration(nodes[place(i)].mass, F)});
  }
  return results;
}

std::vector<Result> scatter(const std::vector<NodeData>& nodes, const std::vector<SpringData>& springs,
                            const ForceLaw& law) {
  std::vector<Vec3> forces(nodes.size(), Vec3::Zero());
  for (const SpringData& s : springs) {
    const Vec3 onA = given::calcForce(nodes.at(place(s.a)).x, nodes.at(place(s.b)).x, s.stiffness, s.length, law);
    forces[place(s.a)] += onA;
    forces[place(s.b)] -= onA;
  }
  std::vector<Result> results;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    results.push_back({forces[i], given::calcAcceleration(nodes[i].mass, forces[i])});
  }
  return results;
}

}  // namespace oracle
