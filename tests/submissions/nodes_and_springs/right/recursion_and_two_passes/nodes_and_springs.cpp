#include "nodes_and_springs.h"

// first all springs calculate, then all of them distribute

static Vec3 sumFrom(std::size_t first, const Node& node) {
  if (first == node.springs.size()) return Vec3::Zero();
  const Vec3 mine = node.springs[first]->getForce(node);
  return mine + sumFrom(first + 1, node);
}

void Node::calcAcceleration() {
  a.x() = F.x() / mass;
  a.y() = F.y() / mass;
  a.z() = F.z() / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  const bool first = (&node == na);
  Vec3 force((*law)(na->x, nb->x, stiffness, length));
  if (!first) force = -force;
  return force;
}

void Spring::calcForce() { F.noalias() = (*law)(na->x, nb->x, stiffness, length); }

void Body::gather() {
  for (Node& node : nodes) {
    node.F = sumFrom(0, node);
    node.calcAcceleration();
  }
}

void Body::scatter() {
  for (Spring& s : springs) s.calcForce();
  for (Node& node : nodes) node.F << 0, 0, 0;
  for (const Spring& s : springs) {
    *(&s.na->F) += s.F;
    *(&s.nb->F) -= s.F;
  }
  for (Node& node : nodes) node.calcAcceleration();
}
