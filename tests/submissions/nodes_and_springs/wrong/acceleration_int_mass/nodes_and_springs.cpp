// loses: CalcAcceleration, Gather, Scatter; misconception: whole_numbers
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  const int m = mass;
  a = F / m;
}

Vec3 Spring::getForce(const Node& node) const {
  const Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  return &node == na ? force : Vec3(-force);
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
