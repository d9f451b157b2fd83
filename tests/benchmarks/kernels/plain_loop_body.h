#pragma once
#include "plain_loop.h"

namespace muelle::benchmarks {
namespace {

void plainForce(const PlainSpring* springs, std::size_t count, const double* x, double* f, std::size_t numbers) {
  for (std::size_t i = 0; i < numbers; ++i) f[i] = 0.0;
  for (const PlainSpring* s = springs; s < springs + count; ++s) {
    double d[3], square = 0.0;
    for (int c = 0; c < 3; ++c) {
      d[c] = x[3 * s->a + c] - x[3 * s->b + c];
      square += d[c] * d[c];
    }
    const double L = __builtin_sqrt(square);
    const double ratio = -s->k * ((L - s->L0) / L);
    for (int c = 0; c < 3; ++c) {
      f[3 * s->a + c] += ratio * d[c];
      f[3 * s->b + c] -= ratio * d[c];
    }
  }
}

void plainDampedForce(const PlainDampedSpring* springs, std::size_t count, const double* x, const double* v, double* f,
                      std::size_t numbers) {
  for (std::size_t i = 0; i < numbers; ++i) f[i] = 0.0;
  for (const PlainDampedSpring* s = springs; s < springs + count; ++s) {
    double d[3], square = 0.0, speed = 0.0;
    for (int c = 0; c < 3; ++c) {
      d[c] = x[3 * s->a + c] - x[3 * s->b + c];
      square += d[c] * d[c];
      speed += d[c] * (v[3 * s->a + c] - v[3 * s->b + c]);
    }
    const double L = __builtin_sqrt(square);
    const double ratio = (-s->k * (L - s->L0) - s->d * (speed / L)) / L;
    for (int c = 0; c < 3; ++c) {
      f[3 * s->a + c] += ratio * d[c];
      f[3 * s->b + c] -= ratio * d[c];
    }
  }
}

}  // namespace
}  // namespace muelle::benchmarks
