// scatter calculates all springs first, and then each node collects the stored forces with their signs
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  const double inverseMass = 1.0 / mass;
  for (int i = 0; i < 3; ++i) a[i] = F[i] * inverseMass;
}

Vec3 Spring::getForce(const Node& node) const {
  const double sign = (&node == nb) ? -1.0 : 1.0;
  return sign * (*law)(na->x, nb->x, stiffness, length);
}

void Spring::calcForce() { F = (*law)(na->x, nb->x, stiffness, length); }

void Body::gather() {
  for (auto& node : nodes) node.F.setZero();
  for (auto& node : nodes) {
    for (auto* s : node.springs) {
      node.F += s->getForce(node);
    }
  }
  for (auto& node : nodes) node.calcAcceleration();
}

void Body::scatter() {
  for (auto& s : springs) s.calcForce();
  for (auto& node : nodes) {
    node.F.setZero();
    for (const auto* s : node.springs) {
      if (s->na == &node)
        node.F += s->F;
      else
        node.F -= s->F;
    }
    node.calcAcceleration();
  }
}
