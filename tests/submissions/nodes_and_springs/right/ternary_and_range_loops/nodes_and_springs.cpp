#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  a = F / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  Vec3 f = (*law)(na->x, nb->x, stiffness, length);
  return &node == na ? f : Vec3(-f);
}

void Spring::calcForce() {
  F = (*law)(na->x, nb->x, stiffness, length);
}

void Body::gather() {
  for (auto& n : nodes) {
    n.F.setZero();
    for (auto* s : n.springs) {
      n.F += s->getForce(n);
    }
    n.calcAcceleration();
  }
}

void Body::scatter() {
  for (auto& n : nodes) n.F.setZero();

  for (auto& s : springs) {
    s.calcForce();
    s.na->F += s.F;
    s.nb->F -= s.F;
  }

  for (auto& n : nodes) n.calcAcceleration();
}
