// loses: Gather, BothAlike; misconception: doubled
// gather gives the reaction to the other node as well, though that node asks the spring itself, so each force is
// counted twice.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  for (int i = 0; i < 3; i++) a[i] = F[i] / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  if (&node == nb) force *= -1;
  return force;
}

void Spring::calcForce() { F = (*law)(na->x, nb->x, stiffness, length); }

void Body::gather() {
  for (Node& node : nodes) node.F = Vec3::Zero();
  for (Node& node : nodes) {
    for (Spring* spring : node.springs) {
      const Vec3 force = spring->getForce(node);
      Node* other = (&node == spring->na) ? spring->nb : spring->na;
      node.F += force;
      other->F -= force;  // action and reaction
    }
  }
  for (Node& node : nodes) node.calcAcceleration();
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
