#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  const double inverse = 1.0 / mass;
  for (int c = 0; c < 3; ++c) a[c] = inverse * F[c];
}

Vec3 Spring::getForce(const Node& node) const {
  double sign = 1.0;
  if (&node == nb) sign = -1.0;
  return sign * (*law)(na->x, nb->x, stiffness, length);
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
