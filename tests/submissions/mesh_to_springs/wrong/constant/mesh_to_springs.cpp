// loses: all; misconception: constant
#include "mesh_to_springs.h"

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) { return {{0, 1}, {0, 2}, {1, 2}}; }

std::vector<Edge> structuralSprings(int rows, int columns) { return {{0, 1}, {0, 2}, {1, 2}}; }

std::vector<Edge> shearSprings(int rows, int columns) { return {{0, 1}, {0, 2}, {1, 2}}; }

std::vector<Edge> bendingSprings(int rows, int columns) { return {{0, 1}, {0, 2}, {1, 2}}; }

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) { return {1.5, 1.5, 1.5}; }

std::vector<double> equalMasses(double M, int n) { return {1.5, 1.5, 1.5}; }

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) { return {1.5, 1.5, 1.5}; }
