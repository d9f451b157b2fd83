#include "nodes_and_springs.h"

#include <numeric>

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
  std::for_each(nodes.begin(), nodes.end(), [](Node& node) {
    node.F = std::accumulate(node.springs.begin(), node.springs.end(), Vec3(0, 0, 0),
                             [&node](const Vec3& sum, const Spring* spring) { return Vec3(sum + spring->getForce(node)); });
    node.calcAcceleration();
  });
}

void Body::scatter() {
  std::for_each(nodes.begin(), nodes.end(), [](Node& node) { node.F = Vec3::Zero(); });
  std::for_each(springs.begin(), springs.end(), [](Spring& spring) {
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
  });
  std::for_each(nodes.begin(), nodes.end(), [](Node& node) { node.calcAcceleration(); });
}
