// loses: Scatter; misconception: acceleration_with_the_springs
// scatter calculates accelerations inside the loop over the springs, so a node without springs keeps the acceleration
// of the step before.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  for (int i = 0; i < 3; i++) a[i] = F[i] / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  if (&node == nb) force *= -1;
  return force;
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
  for (auto& node : nodes) {
    node.F = Vec3(0, 0, 0);
  }
  for (auto& spring : springs) {
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
    spring.na->calcAcceleration();
    spring.nb->calcAcceleration();
  }
}
