// loses: all; misconception: works_on_copies or nothing_written or constant or zero
// As it was handed out.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {}

Vec3 Spring::getForce(const Node& node) const {
  (void)node;
  return Vec3::Zero();
}

void Spring::calcForce() {}

void Body::gather() {}

void Body::scatter() {}
