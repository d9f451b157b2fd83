#include "nodes_and_springs.h"

namespace {

void clear(std::vector<Node>& nodes) {
  for (Node& node : nodes) node.F = Vec3(0.0, 0.0, 0.0);
}

void accelerate(std::vector<Node>& nodes) {
  for (Node& node : nodes) node.calcAcceleration();
}

}  // namespace

void Node::calcAcceleration() {
  a = F / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  const Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  return &node == na ? force : Vec3(-force);
}

void Spring::calcForce() {
  F = (*law)(na->x, nb->x, stiffness, length);
}

void Body::gather() {
  clear(nodes);
  for (Node& node : nodes) {
    for (const Spring* spring : node.springs) node.F += spring->getForce(node);
  }
  accelerate(nodes);
}

void Body::scatter() {
  clear(nodes);
  for (Spring& spring : springs) {
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
  }
  accelerate(nodes);
}
