#pragma once
/// \file
/// The scenes of the hard cases, as the engine's models. Anchors are pinned nodes and come last, so that node i of a
/// case's definition is node i here. In one dimension the coordinate is the first component, up where there is gravity.

#include "engine/model/model.h"

namespace muelle::hard_cases {

using engine::Model;

enum class Damping { None, Relative, Projected, Drag };

/// H01, H02, H03: mass 1 at x = 1 on a spring k of rest length 0 to the origin, damping d of the given kind.
Model oscillator(double k, Damping kind = Damping::None, double d = 0.0);

/// H04: an elastic pendulum of mass 1 and rest length 1 in the x-z plane, released at (x, z).
Model elasticPendulum(double k, double x, double z);
Model regularPendulum();
Model chaoticPendulum();

/// H05: n nodes of total mass 1, no springs, mean height pulled to h0 = 1 with k = 400.
Model meanHeight(int n);

/// H06: the pendulum that runs in a circle.
Model conicalPendulum();

/// H07: the dumbbell (masses 1 and 3; with drag both 1.5) on its rotating equilibrium.
Model dumbbell(Damping kind);
/// H07 "vibrate": started longer than the equilibrium, projected damping 3.
Model vibratingDumbbell();

/// H08: three nodes, three springs, nothing else.
Model triangle(bool gravity = false);

/// H09 vertical: 100 nodes hanging in a row (1D), at their rest lengths. Drag in units of the mass [1/s].
Model hangingChain(double dragPerMass = 0.0);
/// H09 catenary: 19 nodes between two anchors 1 apart (2D), started straight; `sag` bends the start downwards [m].
Model catenary(double sag, double dragPerMass = 0.0);

/// H10: 50 nodes between fixed ends: along the line (1D), and across it (2D, tension 10).
Model longitudinalChain();
Model transverseChain();

/// H11: stiffness ratio 1e6.
Model stiffnessRatio();

/// H12: a heavy node below a light one, hanging straight (1D) or swinging (2D).
Model heavyBelowLight();
Model heavySwing();

/// H13: two free nodes `distance` apart along x (3D), spring of rest length 1.
Model coincidentNodes(double distance);
/// H13 b: rest length 0 through the anchor; c: rest length 0.5, started at 1.2 along x, crossing the anchor (1D or 3D).
Model zeroLengthOscillator();
Model crossingOscillator(int dimension);

/// H14: a node between two compressed springs, y = `offset` off the line.
Model buckling(double k, double offset);

/// H15: inverted triangle (2D, x-y), with the signed area's stiffness.
Model invertedTriangle(double ka, double y = -1.0);

/// H16: corner-hung cloth.
Model cloth(double k = 1000.0, double d = 0.01);

/// H17: a ball on a penalty plane; H18: at rest on it.
Model bouncingBall();
Model bouncingBallWithoutGravity();
Model restingBall(double drag);
/// H18: ten nodes with unilateral springs above each other, the uppermost of mass `top`.
Model stack(double k, double top, double dragPerMass);

/// H19: a fast node and a thin slab.
Model tunnelling();

/// H20: a node on a rough plane inclined by `degrees` (2D), pressed in by its weight already; `speed` along the plane.
Model incline(double degrees, double speed);
/// Distance that the node of incline() has gone down the plane from its start at (0, 0, 0)'s foot [m].
double downhill(const Vec3& position, const Vec3& start, double degrees);

/// H21: a ball on a plane that damps far above critical.
Model overdampedContact();

/// H22: 1000 N for a millisecond.
Model pulse();

/// H23: drag alone, and the damped pair.
Model stiffDrag();
Model stiffPair();

}  // namespace muelle::hard_cases
