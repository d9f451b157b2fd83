#include "lab/meshes/rabbit.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <vector>

namespace muelle::lab {

namespace {

constexpr double blend = 0.0042;  // [m] over which parts melt into each other
constexpr double edge = 0.0062;   // [m] of the triangles: about 2,000 vertices

/// An ellipsoid; in its own frame the radii are along the axes.
struct Ellipsoid {
  Vec3 centre;
  Vec3 radii;
  Mat3 toOwn = Mat3::Identity();

  /// About the distance from its surface: exact at the surface and far from it (Quilez, "ellipsoid SDF").
  double distance(const Vec3& x) const {
    const Vec3 p = toOwn * (x - centre);
    const double k0 = p.cwiseQuotient(radii).norm();
    const double k1 = p.cwiseQuotient(radii.cwiseProduct(radii)).norm();
    return k1 > 0.0 ? k0 * (k0 - 1.0) / k1 : -radii.minCoeff();
  }
};

/// An ellipsoid whose top is turned by `back` towards -x and then by `out` towards +y [degrees].
Ellipsoid turned(const Vec3& centre, const Vec3& radii, double back, double out = 0.0) {
  const double degree = std::numbers::pi / 180.0;
  const Mat3 R = (Eigen::AngleAxisd(-out * degree, Vec3::UnitX()) * Eigen::AngleAxisd(-back * degree, Vec3::UnitY()))
                     .toRotationMatrix();
  return {centre, radii, R.transpose()};
}

Ellipsoid mirrored(const Ellipsoid& e) {
  const Vec3 across(1.0, -1.0, 1.0);
  return {e.centre.cwiseProduct(across), e.radii, across.asDiagonal() * e.toOwn * across.asDiagonal()};
}

std::vector<Ellipsoid> parts() {
  std::vector<Ellipsoid> all = {
      turned({-0.018, 0.0, 0.056}, {0.058, 0.040, 0.047}, -14.0),            // body, higher behind
      turned({0.026, 0.0, 0.066}, {0.030, 0.029, 0.040}, -12.0),             // chest
      turned({0.050, 0.0, 0.112}, {0.033, 0.025, 0.026}, -18.0),             // head
      turned({0.077, 0.0, 0.102}, {0.015, 0.014, 0.012}, 0.0),               // muzzle
      turned({-0.083, 0.0, 0.050}, {0.015, 0.015, 0.015}, 0.0),              // tail
      turned({0.034, 0.015, 0.158}, {0.0140, 0.0105, 0.038}, 6.0, 14.0),     // the ear that stands
      turned({0.009, -0.015, 0.151}, {0.0140, 0.0105, 0.037}, 43.0, -14.0),  // the ear that leans back
  };
  const Ellipsoid pairs[] = {
      turned({-0.040, 0.028, 0.040}, {0.035, 0.019, 0.036}, 0.0),    // haunch
      turned({-0.020, 0.037, 0.009}, {0.037, 0.0135, 0.0125}, 0.0),  // hind foot
      turned({0.042, 0.019, 0.036}, {0.0115, 0.0115, 0.034}, -4.0),  // foreleg
      turned({0.056, 0.0195, 0.008}, {0.021, 0.0125, 0.012}, 0.0),   // forepaw
  };
  for (const Ellipsoid& e : pairs) {
    all.push_back(e);
    all.push_back(mirrored(e));
  }
  return all;
}

/// The smooth least of distances, log-sum-exp: below all of them, by less than blend log n.
double united(const std::vector<Ellipsoid>& all, const Vec3& x) {
  double least = 1e9;
  for (const Ellipsoid& e : all) least = std::min(least, e.distance(x));
  double sum = 0.0;
  for (const Ellipsoid& e : all) sum += std::exp((least - e.distance(x)) / blend);
  return least - blend * std::log(sum);
}

/// The greater of two values, smooth where they meet: soles that the ground cuts off.
double smoothGreater(double a, double b) {
  constexpr double softness = 0.003;
  return 0.5 * (a + b + std::sqrt((a - b) * (a - b) + softness * softness));
}

}  // namespace

ImplicitBody rabbitBody() {
  const std::vector<Ellipsoid> all = parts();
  const auto value = [all](const Vec3& x) { return smoothGreater(united(all, x), -x.z()); };
  // Not at round numbers: the grid should meet neither the plane of symmetry nor the ground.
  return {value, {-0.1172, -0.0711, -0.0123}, {0.1151, 0.0707, 0.2213}};
}

engine::SurfaceMesh rabbitMesh() {
  engine::SurfaceMesh mesh = triangulate(rabbitBody(), edge);
  double low = 1.0;
  double high = 0.0;
  for (const Vec3& x : mesh.vertices) {
    low = std::min(low, x.z());
    high = std::max(high, x.z());
  }
  for (Vec3& x : mesh.vertices) x = (x - Vec3(0.0, 0.0, low)) * (rabbitHeight / (high - low));
  return mesh;
}

std::string offText(const engine::SurfaceMesh& mesh, const std::string& title) {
  std::string text = fmt::format("OFF\n# {}\n{} {} 0\n", title, mesh.vertices.size(), mesh.triangles.size());
  const auto rounded = [](double x) { return std::round(x * 1e5) / 1e5 + 0.0; };  // no -0
  for (const Vec3& x : mesh.vertices) {
    text += fmt::format("{:.5g} {:.5g} {:.5g}\n", rounded(x[0]), rounded(x[1]), rounded(x[2]));
  }
  for (const engine::Triangle& t : mesh.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

}  // namespace muelle::lab
