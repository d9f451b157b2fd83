/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it.

#include "nodes_and_springs.h"

#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

namespace {

using Nodes = std::vector<NodeData>;
using Springs = std::vector<SpringData>;
using Results = std::vector<Result>;

std::size_t place(int i) { return static_cast<std::size_t>(i); }

/// What nodes and springs hold before (nodes_and_springs.h).
const Vec3 left(3, -5, 7);

Results withAccelerations(const Nodes& nodes, const std::vector<Vec3>& forces) {
  Results results;
  for (std::size_t i = 0; i < nodes.size(); ++i) results.push_back({forces[i], forces[i] / nodes[i].mass});
  return results;
}

std::vector<Vec3> rightForces(const Nodes& nodes, const Springs& springs, const ForceLaw& law) {
  std::vector<Vec3> forces;
  for (const Result& result : oracle::scatter(nodes, springs, law)) forces.push_back(result.F);
  return forces;
}

Vec3 onA(const Nodes& nodes, const SpringData& s, const ForceLaw& law) {
  return law(nodes.at(place(s.a)).x, nodes.at(place(s.b)).x, s.stiffness, s.length);
}

/// The right forces, changed one by one.
template <class Change>
Results changedForces(const Nodes& nodes, const Springs& springs, const ForceLaw& law, const Change& change) {
  std::vector<Vec3> forces = rightForces(nodes, springs, law);
  for (Vec3& F : forces) F = change(F);
  return withAccelerations(nodes, forces);
}

/// Each spring does something to the forces of its nodes.
template <class Distribute>
Results distributed(const Nodes& nodes, const Springs& springs, const ForceLaw& law, const Distribute& distribute) {
  std::vector<Vec3> forces(nodes.size(), Vec3::Zero());
  for (const SpringData& s : springs) distribute(forces[place(s.a)], forces[place(s.b)], onA(nodes, s, law));
  return withAccelerations(nodes, forces);
}

Results untouched(const Nodes& nodes) { return Results(nodes.size(), Result{left, left}); }

bool hasSpring(std::size_t node, const Springs& springs) {
  for (const SpringData& s : springs) {
    if (place(s.a) == node || place(s.b) == node) return true;
  }
  return false;
}

}  // namespace

// --- getForce -------------------------------------------------------------------------------------------------------

#define GET_FORCE_MISTAKE(id, ...)                                                                               \
  MUELLE_MISTAKE(getForce, id,                                                                                   \
                 []([[maybe_unused]] const Vec3& xa, [[maybe_unused]] const Vec3& xb,                            \
                    [[maybe_unused]] double stiffness, [[maybe_unused]] double length, [[maybe_unused]] int end, \
                    [[maybe_unused]] const ForceLaw& law) -> Vec3 { return __VA_ARGS__; })

GET_FORCE_MISTAKE(same_at_both_ends, law(xa, xb, stiffness, length));
GET_FORCE_MISTAKE(wrong_sign, -oracle::getForce(xa, xb, stiffness, length, end, law));
GET_FORCE_MISTAKE(half_for_each_end, 0.5 * oracle::getForce(xa, xb, stiffness, length, end, law));
GET_FORCE_MISTAKE(ends_told_by_place, xa == xb ? Vec3(law(xa, xb, stiffness, length))
                                               : oracle::getForce(xa, xb, stiffness, length, end, law));
/// na is taken to be the end further left, or further right; where there is none, the one as the other.
#define END_BY_ORDER(name, sign)                                           \
  namespace name {                                                         \
  GET_FORCE_MISTAKE(ends_by_order, (sign)*law(xa, xb, stiffness, length)); \
  }
END_BY_ORDER(further_left, (end == 0 ? xa[0] > xb[0] : xb[0] > xa[0]) ? -1 : 1)
END_BY_ORDER(further_left_or_even, (end == 0 ? xa[0] < xb[0] : xb[0] < xa[0]) ? 1 : -1)
END_BY_ORDER(further_right, (end == 0 ? xa[0] < xb[0] : xb[0] < xa[0]) ? -1 : 1)
GET_FORCE_MISTAKE(second_end_only, end == 1 ? Vec3(law(xb, xa, stiffness, length)) : Vec3(Vec3::Zero()));
GET_FORCE_MISTAKE(first_end_only, end == 0 ? Vec3(law(xa, xb, stiffness, length)) : Vec3(Vec3::Zero()));
GET_FORCE_MISTAKE(swapped, oracle::getForce(xa, xb, length, stiffness, end, law));
GET_FORCE_MISTAKE(force_left_before, end == 0 ? left : Vec3(-left));
/// The node that asks stands first, in place of a sign: a law that knows its ends answers the same.
namespace asked_in_turn {
Vec3 turned(const Vec3& xa, const Vec3& xb, double stiffness, double length, int end, const ForceLaw& law) {
  return end == 0 ? law(xa, xb, stiffness, length) : law(xb, xa, stiffness, length);
}
GET_FORCE_MISTAKE(wrong_sign, -turned(xa, xb, stiffness, length, end, law));
GET_FORCE_MISTAKE(half_for_each_end, 0.5 * turned(xa, xb, stiffness, length, end, law));
GET_FORCE_MISTAKE(swapped, turned(xa, xb, length, stiffness, end, law));
GET_FORCE_MISTAKE(second_end_only, end == 1 ? Vec3(-law(xa, xb, stiffness, length)) : Vec3(Vec3::Zero()));
GET_FORCE_MISTAKE(same_at_both_ends, -law(xa, xb, stiffness, length));
}  // namespace asked_in_turn
/// Turned about twice, by a minus and by the order of the ends.
namespace turned_twice {
GET_FORCE_MISTAKE(same_at_both_ends,
                  end == 0 ? Vec3(law(xa, xb, stiffness, length)) : Vec3(-law(xb, xa, stiffness, length)));
}
namespace without_asking_which_end {
GET_FORCE_MISTAKE(force_left_before, left);
GET_FORCE_MISTAKE(same_at_both_ends, law(xb, xa, stiffness, length));
}  // namespace without_asking_which_end
MUELLE_COMMON_MISTAKE(getForce, doubled);

// --- calcForce ------------------------------------------------------------------------------------------------------

#define CALC_FORCE_MISTAKE(id, ...)                                                                           \
  MUELLE_MISTAKE(                                                                                             \
      calcForce, id,                                                                                          \
      []([[maybe_unused]] const Vec3& xa, [[maybe_unused]] const Vec3& xb, [[maybe_unused]] double stiffness, \
         [[maybe_unused]] double length, [[maybe_unused]] const ForceLaw& law) -> Vec3 { return __VA_ARGS__; })

CALC_FORCE_MISTAKE(force_on_b, law(xb, xa, stiffness, length));
CALC_FORCE_MISTAKE(adds_to_what_was, left + law(xa, xb, stiffness, length));
namespace minus {
CALC_FORCE_MISTAKE(adds_to_what_was, left - law(xa, xb, stiffness, length));
}
CALC_FORCE_MISTAKE(nothing_written, left);
CALC_FORCE_MISTAKE(swapped, law(xa, xb, length, stiffness));
CALC_FORCE_MISTAKE(half_for_each_end, 0.5 * law(xa, xb, stiffness, length));

// --- calcAcceleration -----------------------------------------------------------------------------------------------

#define ACCELERATION_MISTAKE(id, ...) \
  MUELLE_MISTAKE(calcAcceleration, id, []([[maybe_unused]] double mass, const Vec3& F) -> Vec3 { return __VA_ARGS__; })

ACCELERATION_MISTAKE(multiplied_by_mass, F* mass);
ACCELERATION_MISTAKE(missing_mass, F);
ACCELERATION_MISTAKE(adds_to_what_was, left + F / mass);
ACCELERATION_MISTAKE(gravity_too, F / mass - Vec3(0, 0, 9.81));
MUELLE_MISTAKE(calcAcceleration, nothing_written, [](double, const Vec3&) { return left; });
MUELLE_COMMON_MISTAKE(calcAcceleration, wrong_sign);

// --- both programs --------------------------------------------------------------------------------------------------

#define PROGRAM_MISTAKE(function, id, ...)                                                        \
  MUELLE_MISTAKE(function, id,                                                                    \
                 []([[maybe_unused]] const Nodes& nodes, [[maybe_unused]] const Springs& springs, \
                    [[maybe_unused]] const ForceLaw& law) -> Results { return __VA_ARGS__; })
#define BOTH_PROGRAMS_MISTAKE(id, ...)      \
  PROGRAM_MISTAKE(gather, id, __VA_ARGS__); \
  PROGRAM_MISTAKE(scatter, id, __VA_ARGS__)

BOTH_PROGRAMS_MISTAKE(not_reset, changedForces(nodes, springs, law, [](const Vec3& F) { return Vec3(left + F); }));
BOTH_PROGRAMS_MISTAKE(wrong_sign, changedForces(nodes, springs, law, [](const Vec3& F) { return Vec3(-F); }));
BOTH_PROGRAMS_MISTAKE(doubled, changedForces(nodes, springs, law, [](const Vec3& F) { return Vec3(2 * F); }));
BOTH_PROGRAMS_MISTAKE(works_on_copies, untouched(nodes));

namespace {

template <class Change>
Results changedAccelerations(Results results, const Change& change) {
  for (std::size_t i = 0; i < results.size(); ++i) change(results[i], i);
  return results;
}

Results right(const Nodes& nodes, const Springs& springs, const ForceLaw& law) {
  return oracle::scatter(nodes, springs, law);
}

/// The force of the last spring of each node alone.
Results lastOfEachNode(const Nodes& nodes, const Springs& springs, const ForceLaw& law) {
  return distributed(nodes, springs, law, [](Vec3& Fa, Vec3& Fb, const Vec3& F) {
    Fa = F;
    Fb = -F;
  });
}

/// The force of the first spring of each node alone.
Results firstOfEachNode(const Nodes& nodes, const Springs& springs, const ForceLaw& law) {
  Springs backwards(springs.rbegin(), springs.rend());
  return lastOfEachNode(nodes, backwards, law);
}

/// The last spring of a node sees F complete; one that has none keeps the acceleration of before.
Results accelerationsOfThoseWithSprings(const Nodes& nodes, const Springs& springs, const ForceLaw& law) {
  return changedAccelerations(right(nodes, springs, law), [&](Result& result, std::size_t i) {
    if (!hasSpring(i, springs)) result.a = left;
  });
}

Results lastNodeUntouched(const Nodes& nodes, const Springs& springs, const ForceLaw& law) {
  Results results = right(nodes, springs, law);
  if (!results.empty()) results.back() = {left, left};
  return results;
}

/// Springs end in one node, the one named first, or in the other.
Results oneEndOnly(const Nodes& nodes, const Springs& springs, const ForceLaw& law, bool isFirst) {
  return distributed(nodes, springs, law, [isFirst](Vec3& Fa, Vec3& Fb, const Vec3& F) {
    if (isFirst) Fa += F;
    if (!isFirst) Fb -= F;
  });
}

/// Forces of before set to zero only where `isReset` says so.
template <class IsReset>
Results resetWhere(const Nodes& nodes, const Springs& springs, const ForceLaw& law, const IsReset& isReset) {
  std::vector<Vec3> forces = rightForces(nodes, springs, law);
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (!isReset(i)) forces[i] += left;
  }
  return withAccelerations(nodes, forces);
}

/// A spring sets the forces of its nodes to zero before it adds its own: the last one is left.
Results resetByEachSpring(const Nodes& nodes, const Springs& springs, const ForceLaw& law, const Vec3& before = left) {
  std::vector<Vec3> forces(nodes.size(), before);
  for (const SpringData& s : springs) {
    forces[place(s.a)] = onA(nodes, s, law);
    forces[place(s.b)] = -onA(nodes, s, law);
  }
  return withAccelerations(nodes, forces);
}

/// Accelerations while the forces are still being added up: of the nodes of each spring, after it.
Results oldForce(const Nodes& nodes, const Springs& springs, const ForceLaw& law) {
  std::vector<Vec3> forces(nodes.size(), Vec3::Zero());
  for (const SpringData& s : springs) {
    forces[place(s.a)] += left;
    forces[place(s.b)] -= left;
  }
  (void)law;
  return withAccelerations(nodes, forces);
}

}  // namespace

/// Forces are set to zero with the springs: a node that has none keeps what it had.
namespace with_the_springs {
BOTH_PROGRAMS_MISTAKE(not_reset, resetWhere(nodes, springs, law, [&](std::size_t i) { return hasSpring(i, springs); }));
}
/// The forces are there, and the last node is not accelerated.
namespace not_accelerated {
BOTH_PROGRAMS_MISTAKE(last_node_left_out,
                      changedAccelerations(right(nodes, springs, law), [&](Result& result, std::size_t i) {
                        if (i + 1 == nodes.size()) result.a = left;
                      }));
}
BOTH_PROGRAMS_MISTAKE(small_forces_dropped, distributed(nodes, springs, law, [](Vec3& Fa, Vec3& Fb, const Vec3& F) {
                        if (F.norm() < 1e-9) return;
                        Fa += F;
                        Fb -= F;
                      }));
BOTH_PROGRAMS_MISTAKE(last_spring_only, lastOfEachNode(nodes, springs, law));
BOTH_PROGRAMS_MISTAKE(no_acceleration, changedAccelerations(right(nodes, springs, law),
                                                            [](Result& result, std::size_t) { result.a = left; }));
BOTH_PROGRAMS_MISTAKE(acceleration_too_early,
                      changedAccelerations(right(nodes, springs, law),
                                           [](Result& result, std::size_t) { result.a = Vec3::Zero(); }));
BOTH_PROGRAMS_MISTAKE(acceleration_with_the_springs, accelerationsOfThoseWithSprings(nodes, springs, law));
BOTH_PROGRAMS_MISTAKE(last_node_left_out, lastNodeUntouched(nodes, springs, law));
BOTH_PROGRAMS_MISTAKE(multiplied_by_mass,
                      changedAccelerations(right(nodes, springs, law), [&](Result& result, std::size_t i) {
                        result.a = result.F * nodes[i].mass;
                      }));
PROGRAM_MISTAKE(gather, first_spring_only, firstOfEachNode(nodes, springs, law));
PROGRAM_MISTAKE(scatter, without_reaction, oneEndOnly(nodes, springs, law, true));
PROGRAM_MISTAKE(scatter, same_on_both_nodes, distributed(nodes, springs, law, [](Vec3& Fa, Vec3& Fb, const Vec3& F) {
                  Fa += F;
                  Fb += F;
                }));
PROGRAM_MISTAKE(scatter, reset_by_each_spring, resetByEachSpring(nodes, springs, law));
namespace backwards {
PROGRAM_MISTAKE(scatter, reset_by_each_spring,
                resetByEachSpring(nodes, Springs(springs.rbegin(), springs.rend()), law));
}
/// And before all of them, in a loop. In their own order the last spring of each node is left: last_spring_only.
namespace once_more_backwards {
PROGRAM_MISTAKE(scatter, reset_by_each_spring,
                resetByEachSpring(nodes, Springs(springs.rbegin(), springs.rend()), law, Vec3::Zero()));
}
PROGRAM_MISTAKE(scatter, force_left_before, oldForce(nodes, springs, law));

// --- general position -----------------------------------------------------------------------------------------------

namespace {

using muelle::Random;
using muelle::threeDigits;

const ForceLaw hooke = [](const Vec3& xa, const Vec3& xb, double stiffness, double length) -> Vec3 {
  const double L = (xa - xb).norm();
  return L > 0 ? Vec3(-stiffness * (L - length) / L * (xa - xb)) : Vec3(Vec3::Zero());
};

Nodes someNodes(Random& random) {
  Nodes nodes;
  for (int i = 0; i < 4; ++i)
    nodes.push_back({threeDigits(random.positive(3.0, 90.0)), threeDigits(random.vector3(100.0))});
  return nodes;
}

Springs someSprings(Random& random) {
  Springs springs;
  for (int i = 0; i < 5; ++i) {
    const int a = random.integer(0, 3);
    springs.push_back(
        {a, (a + random.integer(1, 3)) % 4, threeDigits(random.positive(5.0, 500.0)), random.rounded(40.0, 160.0)});
  }
  return springs;
}

}  // namespace

MUELLE_ARGUMENTS(getForce, [](Random& random) {
  const Vec3 xa = threeDigits(random.vector3(100.0)), xb = threeDigits(random.vector3(100.0));
  const double stiffness = threeDigits(random.positive(5.0, 500.0)), length = random.rounded(40.0, 160.0);
  const int end = random.integer(0, 1);
  const ForceLaw law = hooke;
  return std::tuple(xa, xb, stiffness, length, end, law);
});
MUELLE_ARGUMENTS(calcForce, [](Random& random) {
  const Vec3 xa = threeDigits(random.vector3(100.0)), xb = threeDigits(random.vector3(100.0));
  const double stiffness = threeDigits(random.positive(5.0, 500.0)), length = random.rounded(40.0, 160.0);
  const ForceLaw law = hooke;
  return std::tuple(xa, xb, stiffness, length, law);
});
MUELLE_ARGUMENTS(calcAcceleration, [](Random& random) {
  const double mass = threeDigits(random.positive(3.0, 90.0));
  const Vec3 F = threeDigits(random.vector3(300.0));
  return std::tuple(mass, F);
});
MUELLE_ARGUMENTS(gather, [](Random& random) {
  const Nodes nodes = someNodes(random);
  const Springs springs = someSprings(random);
  const ForceLaw law = hooke;
  return std::tuple(nodes, springs, law);
});
MUELLE_ARGUMENTS(scatter, [](Random& random) {
  const Nodes nodes = someNodes(random);
  const Springs springs = someSprings(random);
  const ForceLaw law = hooke;
  return std::tuple(nodes, springs, law);
});
