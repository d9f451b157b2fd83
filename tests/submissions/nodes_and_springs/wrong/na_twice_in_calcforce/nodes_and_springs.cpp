// loses: CalcForce, Scatter, BothAlike, Questions, AtRest; misconception: zero
// calcForce passes the position of na for both ends of the spring to the law (nb is forgotten, copy-paste slip).
#include "nodes_and_springs.h"

void Node::calcAcceleration() { a = F / mass; }

Vec3 Spring::getForce(const Node& node) const {
  const bool first = &node == na;
  const Vec3 f = (*law)(na->x, nb->x, stiffness, length);
  return first ? f : Vec3(-f);
}

void Spring::calcForce() { F = (*law)(na->x, na->x, stiffness, length); }

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
  for (Node& node : nodes) node.F = Vec3::Zero();
  for (Spring& spring : springs) {
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
  }
  for (Node& node : nodes) node.calcAcceleration();
}
