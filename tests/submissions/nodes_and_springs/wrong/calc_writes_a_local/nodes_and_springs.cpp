// loses: CalcForce, Scatter, BothAlike, AtRest; misconception: nothing_written or force_left_before
// A local variable has the name of the member.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  a = F / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  const Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  return &node == na ? force : Vec3(-force);
}

void Spring::calcForce() {
  const Vec3 F = (*law)(na->x, nb->x, stiffness, length);
  (void)F;
}

void Body::gather() {
  for (Node& node : nodes) {
    node.F = Vec3::Zero();
    for (Spring* spring : node.springs) {
      node.F += spring->getForce(node);
    }
    node.calcAcceleration();
  }
}

void Body::scatter() {
  for (Node& node : nodes) node.F = Vec3::Zero();
  for (Spring& spring : springs) {
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
  }
  for (Node& node : nodes) node.calcAcceleration();
}
