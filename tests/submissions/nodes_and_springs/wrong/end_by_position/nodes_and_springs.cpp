// loses: GetForce; misconception: ends_told_by_place
// getForce tells the two ends apart by their positions and not by their addresses, so nb gets the force of na where
// both are at one place.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  for (int i = 0; i < 3; i++) a[i] = F[i] / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  const Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  return node.x == na->x ? force : Vec3(-force);
}

void Spring::calcForce() {
  const Vec3 xa = na->x;
  const Vec3 xb = nb->x;
  F = (*law)(xa, xb, stiffness, length);
}

void Body::gather() {
  for (std::size_t i = 0; i < nodes.size(); i++) {
    Node& n = nodes[i];
    n.F.setZero();
    for (std::size_t s = 0; s < n.springs.size(); s++) {
      n.F += n.springs[s]->getForce(n);
    }
    n.calcAcceleration();
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
