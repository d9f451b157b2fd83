// loses: all; misconception: zero
#include "mesh_to_springs.h"

std::vector<Edge> meshEdges(const std::vector<Triangle>& triangles) { return {}; }

std::vector<Edge> structuralSprings(int rows, int columns) { return {}; }

std::vector<Edge> shearSprings(int rows, int columns) { return {}; }

std::vector<Edge> bendingSprings(int rows, int columns) { return {}; }

std::vector<double> restLengths(const std::vector<Vec3>& nodes, const std::vector<Edge>& edges) { return {}; }

std::vector<double> equalMasses(double M, int n) { return {}; }

std::vector<double> massesByArea(const std::vector<Vec3>& nodes, const std::vector<Triangle>& triangles,
                                 double density) { return {}; }
