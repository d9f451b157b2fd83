#pragma once
/// \file
/// The scenes with numbers from a seed: so near to the public ones that who does well there does well here, with a
/// draught that is another one.

#include "course/testing/random.h"
#include "scenes.h"

namespace scenes {

/// Of three digits, within two per cent.
inline double near(muelle::Random& random, double number) { return random.rounded(0.98 * number, 1.02 * number); }

/// Any directions and phases: the public draught's waves turned somewhere else.
inline Draught nearTo(muelle::Random& random, Draught draught) {
  for (Wave& each : draught.waves) {
    each.w = each.w.norm() * random.roundedDirection();
    each.a = random.rounded(0.9 * each.a, 1.1 * each.a);
    each.phase = random.rounded(0.1, 6.2);
  }
  return draught;
}

inline RabbitNumbers rabbitFrom(muelle::Random& random) {
  RabbitNumbers numbers;
  for (double* each : {&numbers.k, &numbers.mass, &numbers.press}) *each = near(random, *each);
  numbers.draught = nearTo(random, numbers.draught);
  return numbers;
}

inline ClothNumbers clothFrom(muelle::Random& random) {
  ClothNumbers numbers;
  for (double* each : {&numbers.k, &numbers.mass, &numbers.swing, &numbers.g}) *each = near(random, *each);
  numbers.draught = nearTo(random, numbers.draught);
  return numbers;
}

inline BallNumbers ballFrom(muelle::Random& random) {
  BallNumbers numbers;
  for (double* each : {&numbers.k, &numbers.mass, &numbers.height, &numbers.g}) *each = near(random, *each);
  numbers.draught = nearTo(random, numbers.draught);
  return numbers;
}

}  // namespace scenes
