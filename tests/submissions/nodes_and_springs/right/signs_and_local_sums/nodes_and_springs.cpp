#include "nodes_and_springs.h"

#include <numeric>

namespace {

/// +1 for the first end of a spring, -1 for the second.
double signOf(const Spring& spring, const Node& node) { return spring.na == &node ? 1.0 : -1.0; }

Vec3 ask(const Spring& spring) { return (*spring.law)(spring.na->x, spring.nb->x, spring.stiffness, spring.length); }

}  // namespace

void Node::calcAcceleration() {
  a = F;
  a /= mass;
}

Vec3 Spring::getForce(const Node& node) const { return signOf(*this, node) * ask(*this); }

void Spring::calcForce() { F = ask(*this); }

void Body::gather() {
  std::for_each(nodes.rbegin(), nodes.rend(), [](Node& node) {
    const Vec3 sum = std::accumulate(node.springs.begin(), node.springs.end(), Vec3(Vec3::Zero()),
                                     [&node](const Vec3& before, const Spring* spring) -> Vec3 {
                                       return before + spring->getForce(node);
                                     });
    node.F = sum;
    node.calcAcceleration();
  });
}

// All springs are calculated first; then their forces are handed out, from the last spring to the first.
void Body::scatter() {
  for (Spring& spring : springs) spring.calcForce();
  std::vector<Vec3> total(nodes.size(), Vec3(0, 0, 0));
  const auto place = [this](const Node* node) { return static_cast<std::size_t>(node - nodes.data()); };
  for (auto spring = springs.rbegin(); spring != springs.rend(); ++spring) {
    total[place(spring->na)] += spring->F;
    total[place(spring->nb)] -= spring->F;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    nodes[i].F = total[i];
    nodes[i].calcAcceleration();
  }
}
