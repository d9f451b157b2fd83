// loses: Gather, BothAlike; misconception: doubled
// returns the force and has given it to the node already
#include "nodes_and_springs.h"

void Node::calcAcceleration() { a = F / mass; }

Vec3 Spring::getForce(const Node& node) const {
  Spring scratch = *this;
  scratch.calcForce();
  if (&node == na) {
    na->F += scratch.F;
    return scratch.F;
  }
  nb->F -= scratch.F;
  return -scratch.F;
}

void Spring::calcForce() {
  const ForceLaw& f = *law;
  F = f(na->x, nb->x, stiffness, length);
}

void Body::gather() {
  for (auto it = nodes.begin(); it != nodes.end(); ++it) {
    it->F = Vec3::Zero();
    for (auto s = it->springs.begin(); s != it->springs.end(); ++s) {
      const Vec3 f = (*s)->getForce(*it);
      it->F += f;
    }
    it->calcAcceleration();
  }
}

void Body::scatter() {
  for (auto it = nodes.begin(); it != nodes.end(); ++it) it->F = Vec3::Zero();
  for (auto s = springs.begin(); s != springs.end(); ++s) {
    s->calcForce();
    s->na->F += s->F;
    s->nb->F -= s->F;
  }
  for (auto it = nodes.begin(); it != nodes.end(); ++it) it->calcAcceleration();
}
