#include "harness/demo.h"

#include "harness/triangle_mesh.h"
#include "mesh_to_springs.h"

#include <algorithm>
#include <limits>
#include <numeric>

// The rabbit as a net of springs, how long these are, how heavy its nodes, and the three kinds of springs of a grid.

namespace {

using Numbers = std::vector<double>;

constexpr double density = 0.2;  // [kg/m^2], of the rabbit's skin
constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// Many lines, each of which ends in a gap.
struct Lines {
  Numbers x, y;

  void add(const Numbers& alongX, const Numbers& alongY) {
    x.insert(x.end(), alongX.begin(), alongX.end());
    y.insert(y.end(), alongY.begin(), alongY.end());
    x.push_back(gap);
    y.push_back(gap);
  }
};

bool isThere(const Edge& edge, std::size_t nodes) {
  return std::ranges::all_of(edge, [nodes](int i) { return i >= 0 && static_cast<std::size_t>(i) < nodes; });
}

const Vec3& at(const std::vector<Vec3>& nodes, int i) { return nodes[static_cast<std::size_t>(i)]; }

/// Only edges between nodes that are there can be drawn or measured.
std::vector<Edge> drawable(std::vector<Edge> edges, std::size_t nodes) {
  std::erase_if(edges, [nodes](const Edge& edge) { return !isThere(edge, nodes); });
  return edges;
}

/// The nearer half of the rabbit, seen from its right side; long springs and short ones in colours of their own.
muelle::Figure wireframe(const muelle::TriangleMesh& rabbit, const std::vector<Edge>& edges, const Numbers& lengths) {
  constexpr double mm = 1e-3;
  Lines shorter, longer;
  for (std::size_t s = 0; s < std::min(edges.size(), lengths.size()); ++s) {
    const Vec3 a = at(rabbit.nodes, edges[s][0]), b = at(rabbit.nodes, edges[s][1]);
    if (a[1] + b[1] > 0) continue;
    (lengths[s] < 5 * mm ? shorter : longer).add({a[0], b[0]}, {a[2], b[2]});
  }
  muelle::Figure figure("wireframe", "The rabbit's springs: its near side", "x [m]");
  figure.equalAxes();
  figure.panel("z [m]")
      .expectX(-0.1, 0.1)
      .expect(0.0, 0.19)
      .mesh("5 mm and longer", longer.x, longer.y)
      .mesh("shorter than 5 mm", shorter.x, shorter.y);
  return figure;
}

/// Steps of a histogram: how many values lie in each of `count` bins of [0, most).
Lines histogram(const Numbers& values, double most, int count) {
  Numbers bins(static_cast<std::size_t>(count), 0.0);
  for (const double value : values) {
    if (value >= 0 && value < most) ++bins[static_cast<std::size_t>(value / most * count)];
  }
  Lines steps;
  for (std::size_t i = 0; i < bins.size(); ++i) {
    const double width = most / count, left = width * static_cast<double>(i);
    steps.x.insert(steps.x.end(), {left, left + width});
    steps.y.insert(steps.y.end(), {bins[i], bins[i]});
  }
  return steps;
}

Numbers scaled(Numbers values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

muelle::Figure restLengthsOf(const Numbers& lengths) {
  const Lines steps = histogram(scaled(lengths, 1e3), 10.0, 50);
  muelle::Figure figure("lengths", "The rabbit's springs by their rest length", "rest length [mm]");
  figure.panel("number of springs").line("springs", steps.x, steps.y).expect(0, 950);
  return figure;
}

muelle::Figure massesOf(const muelle::TriangleMesh& rabbit) {
  const Numbers masses = submission::massesByArea(rabbit.nodes, rabbit.triangles, density);
  const double M = std::accumulate(masses.begin(), masses.end(), 0.0);
  const Numbers equal = submission::equalMasses(M, static_cast<int>(rabbit.nodes.size()));
  const Lines steps = histogram(scaled(masses, 1e6), 10.0, 50);
  muelle::Figure figure("masses", "The rabbit's nodes by their mass", "mass of a node [mg]");
  auto panel = figure.panel("number of nodes");
  panel.line("by area", steps.x, steps.y).expect(0, 200);
  const double m = equal.empty() ? 0.0 : 1e6 * equal.front();
  panel.line("M/n", {m, m}, {0, 200});
  return figure;
}

constexpr int rows = 4, columns = 6;

/// Nodes of the grid by number: columns to the right, rows downwards.
double gridX(int node) { return node % columns; }
double gridY(int node) { return -(node / columns); }

/// Springs of the grid, each as a bow: what goes from node to node over another one is seen beside it.
Lines bows(const std::vector<Edge>& springs, double height) {
  constexpr int pieces = 12;
  Lines lines;
  for (const auto& [a, b] : drawable(springs, rows * columns)) {
    Numbers x, y;
    const double dx = gridX(b) - gridX(a), dy = gridY(b) - gridY(a);
    for (int i = 0; i <= pieces; ++i) {
      const double t = static_cast<double>(i) / pieces, bow = 4 * t * (1 - t) * height;
      x.push_back(gridX(a) + t * dx - bow * dy);
      y.push_back(gridY(a) + t * dy + bow * dx);
    }
    lines.add(x, y);
  }
  return lines;
}

muelle::Figure grid() {
  muelle::Figure figure("grid", "Springs of a grid of 4 rows and 6 columns", "column");
  figure.equalAxes();
  auto panel = figure.panel("row (downwards, so negative)");
  panel.expectX(-0.5, 5.5).expect(-3.5, 0.5);
  const Lines structural = bows(submission::structuralSprings(rows, columns), 0.0);
  const Lines shear = bows(submission::shearSprings(rows, columns), 0.0);
  const Lines bending = bows(submission::bendingSprings(rows, columns), 0.12);
  panel.line("structural", structural.x, structural.y);
  panel.line("shear", shear.x, shear.y);
  panel.line("bending", bending.x, bending.y);
  Lines nodes;
  for (int i = 0; i < rows * columns; ++i) {
    nodes.x.push_back(gridX(i));
    nodes.y.push_back(gridY(i));
  }
  panel.nodes("nodes", nodes.x, nodes.y);
  return figure;
}

}  // namespace

MUELLE_DEMO {
  const muelle::TriangleMesh rabbit = muelle::readTriangleMesh(MUELLE_EXERCISE_FOLDER "/rabbit.off");
  const std::vector<Edge> edges = drawable(submission::meshEdges(rabbit.triangles), rabbit.nodes.size());
  const Numbers lengths = submission::restLengths(rabbit.nodes, edges);
  return {wireframe(rabbit, edges, lengths), restLengthsOf(lengths), massesOf(rabbit), grid()};
}
