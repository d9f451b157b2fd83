// loses: CalcAcceleration; misconception: adds_to_what_was
// calcAcceleration adds F / mass to the acceleration of the step before where it should replace it.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  // Newton: F = m a
  a += F / mass;
}

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
  for (Spring& spring : springs) {
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
  }
  for (Node& node : nodes) node.calcAcceleration();
}
