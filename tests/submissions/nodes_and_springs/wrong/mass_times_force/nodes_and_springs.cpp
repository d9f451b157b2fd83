// loses: CalcAcceleration; misconception: multiplied_by_mass or multiplied_for_divided
// calcAcceleration multiplies the force by the mass (Newton's law solved the wrong way).
#include "nodes_and_springs.h"

#include <numeric>

void Node::calcAcceleration() { a = mass * F; }

Vec3 Spring::getForce(const Node& node) const {
  Spring copy = *this;
  copy.calcForce();
  return &node == na ? copy.F : Vec3(-copy.F);
}

void Spring::calcForce() { F = law->operator()(na->x, nb->x, stiffness, length); }

void Body::gather() {
  for (Node& n : nodes) {
    n.F = std::accumulate(n.springs.begin(), n.springs.end(), Vec3(Vec3::Zero()),
                          [&n](const Vec3& sum, const Spring* s) -> Vec3 { return sum + s->getForce(n); });
    n.calcAcceleration();
  }
}

void Body::scatter() {
  // springs first into a list of sums, so that no node is written twice
  std::vector<Vec3> sums(nodes.size(), Vec3::Zero());
  for (Spring& s : springs) {
    s.calcForce();
    sums[static_cast<std::size_t>(s.na - nodes.data())] += s.F;
    sums[static_cast<std::size_t>(s.nb - nodes.data())] -= s.F;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].F = sums[i];
    nodes[i].calcAcceleration();
  }
}
