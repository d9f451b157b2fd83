// loses: Questions; misconception: none
// scatter asks each spring once for either end with getForce, twice in all, where one calcForce a spring serves both
// nodes.
#include "nodes_and_springs.h"

void Node::calcAcceleration() { a = F / mass; }

Vec3 Spring::getForce(const Node& node) const {
  const bool first = &node == na;
  const Vec3 f = (*law)(na->x, nb->x, stiffness, length);
  return first ? f : Vec3(-f);
}

void Spring::calcForce() {
  const Vec3 xa = na->x;
  const Vec3 xb = nb->x;
  F = (*law)(xa, xb, stiffness, length);
}

void Body::gather() {
  for (std::size_t i = 0; i < nodes.size(); i++) {
    Node& n = nodes[i];
    n.F.setZero();
    for (std::size_t s = 0; s < n.springs.size(); s++) {
      n.F += n.springs[s]->getForce(n);
    }
    n.calcAcceleration();
  }
}

void Body::scatter() {
  for (Node& node : nodes) node.F = Vec3::Zero();
  for (Spring& spring : springs) {
    spring.na->F += spring.getForce(*spring.na);
    spring.nb->F += spring.getForce(*spring.nb);
  }
  for (Node& node : nodes) node.calcAcceleration();
}
