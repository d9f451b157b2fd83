#include "engine/work.h"

namespace muelle::engine {

Work& Work::operator+=(const Work& other) {
  steps += other.steps;
  inClosedForm += other.inClosedForm;
  rejectedSteps += other.rejectedSteps;
  forceEvaluations += other.forceEvaluations;
  jacobians += other.jacobians;
  factorisations += other.factorisations;
  solves += other.solves;
  newtonIterations += other.newtonIterations;
  events += other.events;
  return *this;
}

}  // namespace muelle::engine
