// loses: all; misconception: works_on_copies or zero or nothing_written
// Everything is set to zero.
#include "nodes_and_springs.h"

void Node::calcAcceleration() { a = Vec3::Zero(); }

Vec3 Spring::getForce(const Node& node) const {
  (void)node;
  return Vec3::Zero();
}

void Spring::calcForce() { F = Vec3::Zero(); }

void Body::gather() {
  for (Node& node : nodes) node.F = node.a = Vec3::Zero();
}

void Body::scatter() {
  for (Node& node : nodes) node.F = node.a = Vec3::Zero();
}
