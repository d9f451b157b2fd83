// loses: GetForce; misconception: swapped or swapped_arguments
#include "nodes_and_springs.h"

// law(xb, xa) = -law(xa, xb): put the node that asks first

void Node::calcAcceleration() { a = (1.0 / mass) * F; }

Vec3 Spring::getForce(const Node& node) const {
  const Node* other = (&node == na) ? nb : na;
  return (*law)(node.x, other->x, length, stiffness);
}

void Spring::calcForce() { F = (*law)(na->x, nb->x, stiffness, length); }

void Body::gather() {
  for (Node& n : nodes) {
    Vec3 total = Vec3::Zero();
    for (const Spring* s : n.springs) total += s->getForce(n);
    n.F = total;
    n.calcAcceleration();
  }
}

void Body::scatter() {
  for (Node& n : nodes) n.F = Vec3::Zero();
  for (Spring& s : springs) {
    s.calcForce();
    Node &first = *s.na, &second = *s.nb;
    first.F += s.F;
    second.F += -s.F;
  }
  for (Node& n : nodes) n.calcAcceleration();
}
