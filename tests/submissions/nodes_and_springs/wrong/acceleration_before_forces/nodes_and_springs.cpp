// loses: Gather; misconception: acceleration_too_early
// gather calls calcAcceleration before the forces of the springs are added, so every acceleration is zero.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  for (int i = 0; i < 3; i++) a[i] = F[i] / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  if (&node == nb) force *= -1;
  return force;
}

void Spring::calcForce() {
  const Vec3 xa = na->x;
  const Vec3 xb = nb->x;
  F = (*law)(xa, xb, stiffness, length);
}

void Body::gather() {
  for (Node& node : nodes) {
    node.F = Vec3::Zero();
    node.calcAcceleration();
    for (Spring* spring : node.springs) {
      node.F += spring->getForce(node);
    }
  }
}

void Body::scatter() {
  for (auto& node : nodes) {
    node.F = Vec3(0, 0, 0);
  }
  for (auto& s : springs) {
    s.calcForce();
    Node& a = *s.na;
    Node& b = *s.nb;
    a.F += s.F;
    b.F -= s.F;
  }
  for (auto& node : nodes) {
    node.calcAcceleration();
  }
}
