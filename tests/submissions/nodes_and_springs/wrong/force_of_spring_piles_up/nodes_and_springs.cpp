// loses: CalcForce; misconception: adds_to_what_was
// calcForce adds to the F that an earlier step has left instead of overwriting it.
#include "nodes_and_springs.h"

void Node::calcAcceleration() {
  a.x() = F.x() / mass;
  a.y() = F.y() / mass;
  a.z() = F.z() / mass;
}

Vec3 Spring::getForce(const Node& node) const {
  Vec3 force = (*law)(na->x, nb->x, stiffness, length);
  if (&node != na) force *= -1;
  return force;
}

void Spring::calcForce() {
  const ForceLaw& f = *law;
  const Vec3& pa = na->x;
  const Vec3& pb = nb->x;
  F += f(pa, pb, stiffness, length);
}

void Body::gather() {
  for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
    node->F = Vec3::Zero();
    for (auto it = node->springs.rbegin(); it != node->springs.rend(); ++it) {
      const Vec3 f = (*it)->getForce(*node);
      node->F = node->F + f;
    }
    node->calcAcceleration();
  }
}

void Body::scatter() {
  std::for_each(nodes.begin(), nodes.end(), [](Node& n) { n.F = Vec3::Zero(); });
  for (auto s = springs.rbegin(); s != springs.rend(); ++s) {
    s->calcForce();
    Node& a = *s->na;
    Node& b = *s->nb;
    a.F = a.F + s->F;
    b.F = b.F - s->F;
  }
  std::for_each(nodes.begin(), nodes.end(), [](Node& n) { n.calcAcceleration(); });
}
