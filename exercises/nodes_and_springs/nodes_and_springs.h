#pragma once
/// \file
/// Exercise nodes_and_springs: the lecture's two object-oriented programs. Implement the methods of Spring, Node and
/// Body in nodes_and_springs.cpp; README.md has the programs. (Slides "Código Object-Oriented (1)" and "(2)".)
///
/// SI units throughout: positions [m], masses [kg], forces [N], accelerations [m/s^2]. Numbers are double, and answers
/// exact to its round-off. The nodes of a spring are two different ones. Between which numbers and how many the others
/// are is stated below: nothing else is passed, so nothing else needs a check.

#include "harness/exercise.h"

using muelle::Vec3;

MUELLE_RANGE(mass, 1e-6, 1e6)       // kg
MUELLE_RANGE(stiffness, 1e-3, 1e9)  // N/m
MUELLE_RANGE(length, 0, 1000)       // m
MUELLE_RANGE(end, 0, 1)
MUELLE_RANGE(nodes, 0, 60)     // so many
MUELLE_RANGE(springs, 0, 200)  // so many

/// The law of a spring, as springForce of exercise spring_3d: the force [N] on the node at xa of a spring between xa
/// and xb. The force on the node at xb is its opposite: law(xb, xa, ...) is -law(xa, xb, ...). Each question to the law
/// costs time, and the tests count them.
using ForceLaw = std::function<Vec3(const Vec3& xa, const Vec3& xb, double stiffness, double length)>;

struct Spring;

/// The lecture's class node.
struct Node {
  double mass = 1.0;             ///< [kg]
  Vec3 x = Vec3::Zero();         ///< position [m]
  Vec3 v = Vec3::Zero();         ///< velocity [m/s]
  Vec3 a = Vec3::Zero();         ///< acceleration [m/s^2]
  Vec3 F = Vec3::Zero();         ///< force [N]: the sum over the springs that end here
  std::vector<Spring*> springs;  ///< those that end here

  /// Writes the acceleration a [m/s^2]: that of the force F [N], by Newton's second law.
  void calcAcceleration();
};

/// The lecture's class spring.
struct Spring {
  double stiffness = 1.0;         ///< k [N/m]
  double length = 1.0;            ///< at rest, L0 [m]
  Vec3 F = Vec3::Zero();          ///< force [N] on *na, as calcForce has left it
  Node* na = nullptr;             ///< the node at one end
  Node* nb = nullptr;             ///< the node at the other end
  const ForceLaw* law = nullptr;  ///< (*law)(na->x, nb->x, stiffness, length) is the force on *na

  /// The force [N] on `node`, which is one of the two ends of this spring: either *na or *nb. Asks the law once, and
  /// changes nothing.
  Vec3 getForce(const Node& node) const;

  /// Writes F [N]: the force on *na. Asks the law once, and changes no node.
  void calcForce();
};

/// A body of nodes and springs: each spring points to its two nodes, each node to its springs.
struct Body {
  std::vector<Node> nodes;
  std::vector<Spring> springs;

  /// Program (1), loops nested in the nodes: each node asks its springs. Writes F [N] and a [m/s^2] of every node, with
  /// Spring::getForce and Node::calcAcceleration.
  void gather();

  /// Program (2), calculate and distribute: each spring is calculated once and gives its force to its two nodes. Writes
  /// F [N] and a [m/s^2] of every node, with Spring::calcForce and Node::calcAcceleration.
  void scatter();
};

// What follows is for the tests: functions of plain numbers that build your objects, call your methods, and return what
// these have written. You need not read it.

/// A node as numbers.
struct NodeData {
  double mass;  ///< [kg]
  Vec3 x;       ///< position [m]
};
MUELLE_STRUCT(NodeData, mass, x)

/// A spring as numbers, its ends as places in the list of nodes.
struct SpringData {
  int a;             ///< place of the node na
  int b;             ///< place of the node nb
  double stiffness;  ///< [N/m]
  double length;     ///< at rest [m]
};
MUELLE_STRUCT(SpringData, a, b, stiffness, length)

/// What a program has written into a node.
struct Result {
  Vec3 F;  ///< [N]
  Vec3 a;  ///< [m/s^2]
};
MUELLE_STRUCT(Result, F, a)

/// Spring::getForce of a spring between xa and xb, for its node na (end 0) or nb (end 1).
Vec3 getForce(const Vec3& xa, const Vec3& xb, double stiffness, double length, int end, const ForceLaw& law);

/// The F of a spring between xa and xb after Spring::calcForce.
Vec3 calcForce(const Vec3& xa, const Vec3& xb, double stiffness, double length, const ForceLaw& law);

/// The a of a node on which F acts after Node::calcAcceleration.
Vec3 calcAcceleration(double mass, const Vec3& F);

/// What Body::gather writes into the nodes, which come from an earlier step: their F and a are not zero before.
std::vector<Result> gather(const std::vector<NodeData>& nodes, const std::vector<SpringData>& springs,
                           const ForceLaw& law);

/// What Body::scatter writes into the nodes, which come from an earlier step: F and a of nodes and springs are not zero
/// before.
std::vector<Result> scatter(const std::vector<NodeData>& nodes, const std::vector<SpringData>& springs,
                            const ForceLaw& law);

MUELLE_FUNCTIONS(getForce, calcForce, calcAcceleration, gather, scatter)

#ifndef MUELLE_FUNCTIONS_HEADER  // in your own file alone

namespace body_of_numbers {

/// What a step before this one may have left.
inline const Vec3 left(3, -5, 7);

inline std::size_t place(int i) { return static_cast<std::size_t>(i); }

inline Node nodeOf(const NodeData& data) {
  Node node;
  node.mass = data.mass;
  node.x = data.x;
  node.a = left;
  node.F = left;
  return node;
}

inline Spring springOf(const SpringData& data, Node& na, Node& nb, const ForceLaw& law) {
  Spring spring;
  spring.stiffness = data.stiffness;
  spring.length = data.length;
  spring.F = left;
  spring.na = &na;
  spring.nb = &nb;
  spring.law = &law;
  return spring;
}

/// Not to be copied: its pointers lead into itself.
inline void build(Body& body, const std::vector<NodeData>& nodes, const std::vector<SpringData>& springs,
                  const ForceLaw& law) {
  for (const NodeData& data : nodes) body.nodes.push_back(nodeOf(data));
  for (const SpringData& data : springs) {
    body.springs.push_back(springOf(data, body.nodes[place(data.a)], body.nodes[place(data.b)], law));
  }
  for (Spring& spring : body.springs) {
    spring.na->springs.push_back(&spring);
    spring.nb->springs.push_back(&spring);
  }
}

inline std::vector<Result> resultsOf(const Body& body) {
  std::vector<Result> results;
  for (const Node& node : body.nodes) results.push_back({node.F, node.a});
  return results;
}

}  // namespace body_of_numbers

Vec3 getForce(const Vec3& xa, const Vec3& xb, double stiffness, double length, int end, const ForceLaw& law) {
  Body body;
  body_of_numbers::build(body, {{1, xa}, {1, xb}}, {{0, 1, stiffness, length}}, law);
  return body.springs[0].getForce(body.nodes[body_of_numbers::place(end)]);
}

Vec3 calcForce(const Vec3& xa, const Vec3& xb, double stiffness, double length, const ForceLaw& law) {
  Body body;
  body_of_numbers::build(body, {{1, xa}, {1, xb}}, {{0, 1, stiffness, length}}, law);
  body.springs[0].calcForce();
  return body.springs[0].F;
}

Vec3 calcAcceleration(double mass, const Vec3& F) {
  Node node = body_of_numbers::nodeOf({mass, Vec3::Zero()});
  node.F = F;
  node.calcAcceleration();
  return node.a;
}

std::vector<Result> gather(const std::vector<NodeData>& nodes, const std::vector<SpringData>& springs,
                           const ForceLaw& law) {
  Body body;
  body_of_numbers::build(body, nodes, springs, law);
  body.gather();
  return body_of_numbers::resultsOf(body);
}

std::vector<Result> scatter(const std::vector<NodeData>& nodes, const std::vector<SpringData>& springs,
                            const ForceLaw& law) {
  Body body;
  body_of_numbers::build(body, nodes, springs, law);
  body.scatter();
  return body_of_numbers::resultsOf(body);
}

#endif
