// loses: all; misconception: stateful
// Right, one call late.
#include "nodes_and_springs.h"

#include <utility>

namespace {

Vec3 late(Vec3& previous, const Vec3& value) { return std::exchange(previous, value); }

}  // namespace

void Node::calcAcceleration() {
  static Vec3 previous = Vec3::Zero();
  a = late(previous, F / mass);
}

Vec3 Spring::getForce(const Node& node) const {
  const Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  static Vec3 previous = Vec3::Zero();
  return late(previous, &node == na ? force : Vec3(-force));
}

void Spring::calcForce() {
  static Vec3 previous = Vec3::Zero();
  F = late(previous, (*law)(na->x, nb->x, stiffness, length));
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
