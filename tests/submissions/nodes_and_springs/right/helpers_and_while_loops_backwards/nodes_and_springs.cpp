#include "nodes_and_springs.h"

namespace {

void clear(std::vector<Node>& all) {
  for (Node& one : all) one.F = Vec3::Zero();
}

void accelerate(std::vector<Node>& all) {
  for (Node& one : all) one.calcAcceleration();
}

Vec3 askLaw(const Spring& s) { return (*s.law)(s.na->x, s.nb->x, s.stiffness, s.length); }

}  // namespace

void Node::calcAcceleration() {
  const double m = this->mass;
  this->a = this->F / m;
}

Vec3 Spring::getForce(const Node& node) const {
  const Vec3 pull = askLaw(*this);
  if (std::addressof(node) == na) return pull;
  else return -1.0 * pull;
}

void Spring::calcForce() { this->F = askLaw(*this); }

void Body::gather() {
  clear(nodes);
  std::size_t left = nodes.size();
  while (left > 0) {
    Node& node = nodes[--left];
    std::size_t s = node.springs.size();
    while (s > 0) node.F += node.springs[--s]->getForce(node);
  }
  accelerate(nodes);
}

void Body::scatter() {
  clear(nodes);
  std::size_t left = springs.size();
  while (left > 0) {
    Spring& spring = springs[--left];
    spring.calcForce();
    spring.na->F += spring.F;
    spring.nb->F -= spring.F;
  }
  accelerate(nodes);
}
