// loses: all; misconception: constant
// a state to look at
#include "time_integration.h"

State explicitEulerStep(const Force&, const VecX&, const State&, double) { return {1.5, VecX{{2.5, 1.0}}, VecX{{2.5, -1.0}}}; }

State midpointStep(const Force&, const VecX&, const State&, double) { return {1.5, VecX{{2.5, 1.0}}, VecX{{2.5, -1.0}}}; }

State verletStep(const PositionForce&, const VecX&, const State&, double) { return {1.5, VecX{{2.5, 1.0}}, VecX{{2.5, -1.0}}}; }

State rungeKuttaStep(const Force&, const VecX&, const State&, double) { return {1.5, VecX{{2.5, 1.0}}, VecX{{2.5, -1.0}}}; }
