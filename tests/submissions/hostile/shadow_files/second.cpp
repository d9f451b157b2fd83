double lumpedMass(double M, int n) { return M / n; }
