// loses: GetForce; misconception: same_at_both_ends
// getForce reverses the force on nb twice, by a minus and by exchanging the two places, so nb gets the same force as
// na.
#include "nodes_and_springs.h"

void Node::calcAcceleration() { a = F / mass; }

Vec3 Spring::getForce(const Node& node) const {
  if (&node == na) return (*law)(na->x, nb->x, stiffness, length);
  // for the other end everything is the other way round
  return -(*law)(nb->x, na->x, stiffness, length);
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
  for (Spring& spring : springs) {
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
  }
  for (Node& node : nodes) node.calcAcceleration();
}
