/// \file
/// Writes the squeezed rabbit of exercise nodes_and_springs, as nodes and springs at rest between two plates:
/// muelle-rabbit-at-rest RABBIT.off FILE.txt.

#include "harness/triangle_mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <map>

namespace {

using muelle::TriangleMesh;
using muelle::Vec3;

constexpr double cell = 0.0145;        // [m], nodes nearer than about that become one
constexpr double reach = 0.0255;       // [m], nodes nearer than that are joined
constexpr double stiffness = 300.0;    // [N/m] of each spring
constexpr double totalMass = 0.5;      // [kg]
constexpr double plateHeight = 0.145;  // [m] of the upper plate: the rabbit is 0.19 m high
constexpr double plateStiffness = 400.0, g = 9.81;

struct Spring {
  std::size_t a, b;
  double length;
};

struct Body {
  std::vector<Vec3> x;
  std::vector<Spring> springs;
  std::vector<Vec3> start = x;  ///< feet and tips of the ears stick to their plates, above and below these places
  double plate = plateHeight;   ///< [m], where the upper plate is

  bool sticks(std::size_t i) const { return start[i][2] < 0.006 || start[i][2] > plateHeight + 0.012; }
};

/// Mean places of the vertices in each cell of a lattice.
std::vector<Vec3> clustered(const std::vector<Vec3>& vertices) {
  std::map<std::array<int, 3>, std::pair<Vec3, int>> cells;
  for (const Vec3& x : vertices) {
    const auto at = [&x](int axis) { return static_cast<int>(std::floor(x[axis] / cell)); };
    auto& [sum, count] = cells.try_emplace({at(0), at(1), at(2)}, Vec3::Zero(), 0).first->second;
    sum += x;
    ++count;
  }
  std::vector<Vec3> places;
  for (const auto& [index, place] : cells) places.push_back(place.first / place.second);
  return places;
}

/// The middle between nodes on opposite sides: a skeleton that keeps the skin from folding in.
void addSkeleton(std::vector<Vec3>& places) {
  std::vector<Vec3> middle;
  for (const Vec3& a : places) {
    for (const Vec3& b : places) {
      const bool areOpposite = a[1] > 0.004 && b[1] < -0.004 && std::hypot(a[0] - b[0], a[2] - b[2]) < 0.6 * cell;
      if (areOpposite && a[1] - b[1] > 0.02) middle.push_back((a + b) / 2);
    }
  }
  for (const Vec3& x : clustered(middle)) places.push_back(x);
}

Body bodyOf(const TriangleMesh& mesh) {
  Body body{clustered(mesh.nodes), {}};
  addSkeleton(body.x);
  body.start = body.x;
  for (std::size_t a = 0; a < body.x.size(); ++a) {
    for (std::size_t b = a + 1; b < body.x.size(); ++b) {
      const double length = (body.x[a] - body.x[b]).norm();
      if (length < reach) body.springs.push_back({a, b, std::round(length * 1e6) / 1e6});
    }
  }
  return body;
}

/// The law of the exercise's demo, k/2 ((L/L0)^2 - 1) along the spring, weight, and plates that push.
std::vector<Vec3> forcesOf(const Body& body) {
  std::vector<Vec3> forces(body.x.size(), Vec3(0, 0, -g * totalMass / static_cast<double>(body.x.size())));
  for (const Spring& s : body.springs) {
    const Vec3 r = body.x[s.a] - body.x[s.b];
    const Vec3 F = -0.5 * stiffness * (r.squaredNorm() / (s.length * s.length) - 1) * r;
    forces[s.a] += F;
    forces[s.b] -= F;
  }
  for (std::size_t i = 0; i < forces.size(); ++i) {
    forces[i][2] += plateStiffness * (std::max(0.0, -body.x[i][2]) - std::max(0.0, body.x[i][2] - body.plate));
    if (body.sticks(i)) forces[i].head<2>() -= plateStiffness * (body.x[i] - body.start[i]).head<2>();
  }
  return forces;
}

double largest(const std::vector<Vec3>& forces) {
  double most = 0;
  for (const Vec3& F : forces) most = std::max(most, F.norm());
  return most;
}

/// Brings the plate down, and lets the body swing with friction until no node has a force left.
void relax(Body& body) {
  constexpr double h = 0.02;  // of unit masses
  constexpr int descent = 20000, most = 400000;
  std::vector<Vec3> v(body.x.size(), Vec3::Zero());
  std::vector<Vec3> forces = forcesOf(body);
  for (int step = 0; step < most && (step < descent || largest(forces) > 1e-10); ++step) {
    body.plate = plateHeight + std::max(0.0, 0.03 * (descent - step) / descent);
    for (std::size_t i = 0; i < v.size(); ++i) {
      v[i] = 0.995 * v[i] + h * forces[i];
      body.x[i] += h * v[i];
    }
    forces = forcesOf(body);
  }
  fmt::print("largest force {:.3g} N\n", largest(forces));
}

void write(const Body& body, const char* file) {
  std::ofstream out(file);
  out << "# A rabbit of nodes and springs, squeezed between the planes z = 0 and z = 0.145 m, at rest; made by\n"
         "# muelle-rabbit-at-rest. Law of a spring: (k/2) ((L/L0)^2 - 1) (xb - xa) on a.\n"
         "# How many nodes and springs; mass [kg], x, y, z [m] of each node; a, b, k [N/m], L0 [m] of each spring.\n";
  out << body.x.size() << ' ' << body.springs.size() << '\n';
  const double m = totalMass / static_cast<double>(body.x.size());
  for (const Vec3& x : body.x) out << fmt::format("{:.6g} {:.9f} {:.9f} {:.9f}\n", m, x[0], x[1], x[2]);
  for (const Spring& s : body.springs) out << fmt::format("{} {} {:g} {:g}\n", s.a, s.b, stiffness, s.length);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc != 3) {
      fmt::print(stderr, "muelle-rabbit-at-rest RABBIT.off FILE.txt\n");
      return 2;
    }
    Body body = bodyOf(muelle::readTriangleMesh(argv[1]));
    fmt::print("{} nodes, {} springs\n", body.x.size(), body.springs.size());
    relax(body);
    write(body, argv[2]);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
