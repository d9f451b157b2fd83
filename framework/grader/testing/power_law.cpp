#include "grader/testing/power_law.h"

#include "course/testing/expect.h"

#include <fmt/format.h>
#include <cmath>

namespace muelle::grader {

void expectPowerLaw(const std::vector<double>& lengths, const std::function<Vec3(double length)>& force,
                    const std::string& what, double bend) {
  const Vec3 first = force(lengths[0]);
  const double size = first.norm();
  if (!(size > 0.0) || !std::isfinite(size)) return;
  const double ratio = size / force(lengths[1]).norm();
  const double power = std::round(std::log(ratio) / std::log(lengths[0] / lengths[1]));
  for (const double length : lengths) {
    // Where the second is zero or no number already, it is compared with the first as it stands.
    const double scale = std::isfinite(power) ? size * std::pow(length / lengths[0], power) : size;
    MUELLE_LABEL(fmt::format("{} of {:.3g} m, relative to what {:.3g} m and {:.3g} m make of it", what, length,
                             lengths[0], lengths[1]));
    EXPECT_VECTOR_NEAR(Vec3(force(length) / scale), Vec3(first / size), bend);
  }
}

}  // namespace muelle::grader
