#include "nodes_and_springs.h"

void Node::calcAcceleration() { a = F / mass; }

Vec3 Spring::getForce(const Node& node) const {
  Spring scratch = *this;  // const method: let a copy do it
  scratch.calcForce();
  if (&node != na) {
    scratch.F *= -1;
  }
  return scratch.F;
}

void Spring::calcForce() {
  const ForceLaw& f = *law;
  F = f(na->x, nb->x, stiffness, length);
}

void Body::gather() {
  for (auto it = nodes.begin(); it != nodes.end(); ++it) {
    it->F = Vec3::Zero();
    for (auto s = it->springs.begin(); s != it->springs.end(); ++s) it->F += (*s)->getForce(*it);
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
