// loses: Scatter, BothAlike, Questions, AtRest; misconception: first_skipped
// the loop over the springs in scatter begins at 1, so the first spring is left out (and never asked).
#include "nodes_and_springs.h"

void Node::calcAcceleration() { a = F / mass; }

Vec3 Spring::getForce(const Node& node) const {
  const Vec3 onA = (*law)(na->x, nb->x, stiffness, length);
  if (&node == na) return onA;
  return -onA;
}

void Spring::calcForce() { F = (*law)(na->x, nb->x, stiffness, length); }

void Body::gather() {
  for (Node& node : nodes) {
    node.F = Vec3::Zero();
    for (const Spring* spring : node.springs) node.F += spring->getForce(node);
    node.calcAcceleration();
  }
}

void Body::scatter() {
  for (Node& node : nodes) node.F = Vec3::Zero();
  for (std::size_t i = 1; i < springs.size(); ++i) {
    Spring& spring = springs[i];
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
  }
  for (Node& node : nodes) node.calcAcceleration();
}
