#pragma once

inline double share(double M, int n) { return M / n; }
