#pragma once
#include "scenes.h"

namespace scenes {

/// Where a node is at the end of a public scene [m], by a method that is much finer than the goals ask for: some
/// nodes, and those at which the reference methods of the frontier are farthest off.
struct End {
  std::size_t node;
  Vec3 x;
};

inline const std::vector<End> rabbitEnds = {
    {0, {-0.04336258124, -0.04609064762, 0.03479921896}}, {75, {0.05725717737, -0.01989101717, 0.03514469479}},
    {675, {-0.07849625473, 0.02173653457, 0.061617103}},  {877, {0.02368800475, -0.03274262163, 0.08099380959}},
    {905, {0.03598207461, 0.02948194526, 0.08007106381}}, {2053, {0.03911189018, -0.02154492172, 0.112297729}},
};
inline const std::vector<End> clothEnds = {
    {0, {3.525440011e-09, 1.54803139e-07, -8.223633953e-07}}, {39, {0.9000068449, 0.06358692528, -0.2931423207}},
    {81, {0.1003791241, 0.2294067101, -0.7648038346}},        {90, {0.0005288854825, 0.2689067431, -0.8568229187}},
    {91, {0.1005288486, 0.2688593135, -0.8566923016}},        {99, {0.9004162398, 0.2566701931, -0.8605745709}},
};
inline const std::vector<End> ballEnds = {
    {0, {3.641969859, 1.25289365, 0.3856230571}},
};

}  // namespace scenes
