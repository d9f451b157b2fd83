// loses: Scatter, BothAlike, AtRest; misconception: same_on_both_nodes
// scatter adds the spring's force to both of its nodes with a plus.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  // F = m a
  a = F / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  if (&node == na) {
    return (*law)(na->x, nb->x, stiffness, length);
  } else {
    return (*law)(nb->x, na->x, stiffness, length);
  }
}

void Spring::calcForce() { F = (*law)(na->x, nb->x, stiffness, length); }

void Body::gather() {
  for (size_t i = 0; i < nodes.size(); i++) {
    Vec3 total(0, 0, 0);
    for (size_t j = 0; j < nodes[i].springs.size(); j++) {
      total += nodes[i].springs[j]->getForce(nodes[i]);
    }
    nodes[i].F = total;
    nodes[i].calcAcceleration();
  }
}

void Body::scatter() {
  for (size_t i = 0; i < nodes.size(); i++) {
    nodes[i].F = Vec3(0, 0, 0);
  }
  for (size_t j = 0; j < springs.size(); j++) {
    springs[j].calcForce();
    springs[j].na->F += springs[j].F;
    springs[j].nb->F += springs[j].F;
  }
  for (size_t i = 0; i < nodes.size(); i++) {
    nodes[i].calcAcceleration();
  }
}
