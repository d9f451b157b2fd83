// loses: GetForce, Questions; misconception: force_left_before
// Believes that calcForce was called before.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  a = F / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  if (&node == na) return F;
  return -F;
}

void Spring::calcForce() {
  F = (*law)(na->x, nb->x, stiffness, length);
}

void Body::gather() {
  for (Node& node : nodes) {
    node.F = Vec3::Zero();
    for (Spring* spring : node.springs) {
      node.F += spring->getForce(node);
    }
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
