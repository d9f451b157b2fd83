#include "nodes_and_springs.h"

#include <numeric>

void Node::calcAcceleration() { a = F.array() / mass; }

Vec3 Spring::getForce(const Node& node) const {
  const double sign = (&node == na) ? 1.0 : -1.0;
  return sign * (*law)(na->x, nb->x, stiffness, length);
}

void Spring::calcForce() { F = getForce(*na); }

void Body::gather() {
  std::for_each(nodes.begin(), nodes.end(), [](Node& node) {
    const auto add = [&node](const Vec3& sum, const Spring* s) -> Vec3 { return sum + s->getForce(node); };
    node.F = std::accumulate(node.springs.begin(), node.springs.end(), Vec3(Vec3::Zero()), add);
    node.calcAcceleration();
  });
}

void Body::scatter() {
  std::for_each(nodes.begin(), nodes.end(), [](Node& node) { node.F.setZero(); });
  std::for_each(springs.begin(), springs.end(), [](Spring& s) {
    s.calcForce();
    s.na->F += s.F;
    s.nb->F -= s.F;
  });
  std::for_each(nodes.begin(), nodes.end(), [](Node& node) { node.calcAcceleration(); });
}
