#include "engine/scene/connectivity.h"

#include "engine/scene/joined_sets.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace muelle::engine {

namespace {

/// The first vertex at each vertex's place.
std::vector<int> firstAtPlace(const std::vector<Vec3>& vertices) {
  const auto place = [&](int i) {
    const Vec3& x = vertices[static_cast<std::size_t>(i)];
    return std::tuple(x[0], x[1], x[2]);
  };
  std::vector<int> order(vertices.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, place);
  std::vector<int> first(vertices.size());
  int present = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || place(order[i]) != place(order[i - 1])) present = order[i];
    first[static_cast<std::size_t>(order[i])] = present;
  }
  return first;
}

std::vector<bool> usedBy(const SurfaceMesh& mesh) {
  std::vector<bool> used(mesh.vertices.size(), false);
  for (const Triangle& t : mesh.triangles) {
    for (const int i : t) used[static_cast<std::size_t>(i)] = true;
  }
  for (const Line& line : mesh.lines) {
    for (const int i : line) used[static_cast<std::size_t>(i)] = true;
  }
  return used;
}

/// Keeps some of the vertices, in their order; no triangle and no line has another one.
void keepVertices(SurfaceMesh& mesh, const std::vector<bool>& keeps) {
  std::vector<int> now(mesh.vertices.size());
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < keeps.size(); ++i) {
    now[i] = static_cast<int>(std::ssize(kept));
    if (keeps[i]) kept.push_back(mesh.vertices[i]);
  }
  mesh.vertices = std::move(kept);
  for (Triangle& t : mesh.triangles) {
    for (int& i : t) i = now[static_cast<std::size_t>(i)];
  }
  for (Line& line : mesh.lines) {
    for (int& i : line) i = now[static_cast<std::size_t>(i)];
  }
}

/// Leaves out the lines from a vertex to itself, and those that are there already.
void dropRepeatedLines(SurfaceMesh& mesh) {
  std::set<Line> there;
  const std::size_t gone = std::erase_if(mesh.lines, [&](const Line& line) {
    return line[0] == line[1] || !there.insert({std::min(line[0], line[1]), std::max(line[0], line[1])}).second;
  });
  mesh.linesLeftOut += static_cast<int>(gone);
}

}  // namespace

Connectivity connectivityOf(const SurfaceMesh& mesh) {
  const std::vector<bool> used = usedBy(mesh);
  const std::vector<int> first = firstAtPlace(mesh.vertices);
  JoinedSets sets(static_cast<int>(std::ssize(mesh.vertices)));
  for (const Triangle& t : mesh.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  for (const Line& line : mesh.lines) sets.join(line[0], line[1]);
  std::set<int> pieces;
  std::set<int> places;
  Connectivity result;
  for (int i = 0; i < std::ssize(mesh.vertices); ++i) {
    if (!used[static_cast<std::size_t>(i)]) continue;
    ++result.vertices;
    pieces.insert(sets.of(i));
    places.insert(first[static_cast<std::size_t>(i)]);
  }
  result.unused = static_cast<int>(std::ssize(mesh.vertices)) - result.vertices;
  result.places = static_cast<int>(std::ssize(places));
  result.pieces = static_cast<int>(std::ssize(pieces));
  return result;
}

void dropUnused(SurfaceMesh& mesh) { keepVertices(mesh, usedBy(mesh)); }

void weld(SurfaceMesh& mesh) {
  const std::vector<int> first = firstAtPlace(mesh.vertices);
  for (Triangle& t : mesh.triangles) {
    for (int& i : t) i = first[static_cast<std::size_t>(i)];
  }
  const std::size_t gone =
      std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  mesh.facesLeftOut += static_cast<int>(gone);
  for (Line& line : mesh.lines) {
    for (int& i : line) i = first[static_cast<std::size_t>(i)];
  }
  dropRepeatedLines(mesh);
  std::vector<bool> isFirst(first.size());
  for (std::size_t i = 0; i < first.size(); ++i) isFirst[i] = first[i] == static_cast<int>(i);
  keepVertices(mesh, isFirst);
}

}  // namespace muelle::engine
