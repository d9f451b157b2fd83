#include "nodes_and_springs.h"

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
  for (std::size_t i = 0; i < nodes.size(); i++) {
    Node* node = &nodes[i];
    Vec3 sum(0, 0, 0);
    for (std::size_t s = 0; s < node->springs.size(); s++) sum = sum + node->springs[s]->getForce(*node);
    node->F = sum;
    node->calcAcceleration();
  }
}

void Body::scatter() {
  for (std::size_t i = 0; i < nodes.size(); i++) nodes[i].F.setZero();
  for (std::size_t s = 0; s < springs.size(); s++) {
    springs[s].calcForce();
    springs[s].na->F += springs[s].F;
    springs[s].nb->F += -springs[s].F;
  }
  for (std::size_t i = 0; i < nodes.size(); i++) nodes[i].calcAcceleration();
}
