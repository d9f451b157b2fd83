// loses: Gather; misconception: acceleration_with_the_springs
// a node without springs keeps its a
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  for (int c = 0; c < 3; c++) {
    a[c] = F[c] / mass;
  }
}

Vec3 Spring::getForce(const Node& node) const {
  Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  if (&node == nb) {
    for (int c = 0; c < 3; c++) force[c] = -force[c];
  }
  return force;
}

void Spring::calcForce() {
  const Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  for (int c = 0; c < 3; c++) F[c] = force[c];
}

void Body::gather() {
  for (std::size_t i = 0; i < nodes.size(); i++) {
    nodes[i].F = Vec3(0, 0, 0);
    for (std::size_t j = 0; j < nodes[i].springs.size(); j++) {
      nodes[i].F = nodes[i].F + nodes[i].springs[j]->getForce(nodes[i]);
      nodes[i].calcAcceleration();
    }
  }
}

void Body::scatter() {
  for (std::size_t i = 0; i < nodes.size(); i++) nodes[i].F = Vec3(0, 0, 0);
  for (std::size_t j = 0; j < springs.size(); j++) {
    Spring& s = springs[j];
    s.calcForce();
    s.na->F = s.na->F + s.F;
    s.nb->F = s.nb->F - s.F;
  }
  for (std::size_t i = 0; i < nodes.size(); i++) nodes[i].calcAcceleration();
}
