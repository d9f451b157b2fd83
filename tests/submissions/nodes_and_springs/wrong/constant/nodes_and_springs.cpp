// loses: all; misconception: constant
#include "nodes_and_springs.h"

void Node::calcAcceleration() { a = Vec3(1, 2, 3); }

Vec3 Spring::getForce(const Node& node) const {
  (void)node;
  return Vec3(1, 2, 3);
}

void Spring::calcForce() { F = Vec3(1, 2, 3); }

void Body::gather() {
  for (Node& node : nodes) node.F = node.a = Vec3(1, 2, 3);
}

void Body::scatter() {
  for (Node& node : nodes) node.F = node.a = Vec3(1, 2, 3);
}
