// loses: Questions; misconception: none
// One question for the size, one for the direction.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  a = F / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  const double size = (*law)(na->x, nb->x, stiffness, length).norm();
  if (size == 0) return Vec3::Zero();
  const Vec3 direction = (*law)(na->x, nb->x, stiffness, length) / size;
  return &node == na ? Vec3(size * direction) : Vec3(-size * direction);
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
