/// \file
/// What the usual mistakes would return: each is a whole function, so that all calls must agree with it. Those that any
/// function may hold (generic_mistakes.h) are listed where the exercise has better words for them.

#include "property_forces.h"

#include "grader/testing/arguments.h"
#include "grader/testing/mistakes.h"

#include <functional>
#include <limits>

namespace {

using Block = Eigen::Matrix3Xd;

Block nodes(const VecX& x) { return Eigen::Map<const Block>(x.data(), 3, x.size() / 3); }
VecX stacked(const Block& block) { return Eigen::Map<const VecX>(block.data(), block.size()); }
double square(double number) { return number * number; }

// --- mean height ----------------------------------------------------------------------------------------------------

double sumOfHeights(const VecX& x) { return nodes(x).row(2).sum(); }
double meanOfAxis(const VecX& x, int axis) { return nodes(x).row(axis).mean(); }
double middleOfExtremes(const VecX& x) { return (nodes(x).row(2).minCoeff() + nodes(x).row(2).maxCoeff()) / 2; }
double meanSize(const VecX& x) { return nodes(x).row(2).cwiseAbs().mean(); }
double withoutFirst(const VecX& x) { return (sumOfHeights(x) - x[2]) / static_cast<double>(x.size() / 3); }
double withoutLast(const VecX& x) { return (sumOfHeights(x) - x[x.size() - 1]) / static_cast<double>(x.size() / 3); }
double ofTheFirst(const VecX& x) { return x[2]; }
double ofTheLast(const VecX& x) { return x[x.size() - 1]; }

double count(const VecX& x) { return static_cast<double>(x.size() / 3); }

/// The same force along z on every node.
VecX lifted(const VecX& x, double force) {
  Block F = Block::Zero(3, x.size() / 3);
  F.row(2).setConstant(force);
  return stacked(F);
}

/// A force along z on every node, of a size that follows from its own height.
template <class Force>
VecX liftedOneByOne(const VecX& x, const Force& force) {
  Block F = Block::Zero(3, x.size() / 3);
  for (Eigen::Index i = 0; i < F.cols(); ++i) F(2, i) = force(x[3 * i + 2]);
  return stacked(F);
}

}  // namespace

/// A wrong mean height, in the function itself and where the energy or the force have it written out.
#define HEIGHT_MISTAKE(id, mean)                                                                            \
  MUELLE_MISTAKE(meanHeight, id, [](const VecX& x) -> double { return mean; });                             \
  MUELLE_MISTAKE(meanHeightEnergy, id,                                                                      \
                 [](const VecX& x, double h0, double k) -> double { return 0.5 * k * square((mean)-h0); }); \
  MUELLE_MISTAKE(meanHeightForce, id,                                                                       \
                 [](const VecX& x, double h0, double k) -> VecX { return lifted(x, -k * ((mean)-h0) / count(x)); })

HEIGHT_MISTAKE(sum_for_mean, sumOfHeights(x));
HEIGHT_MISTAKE(mean_of_all_coordinates, x.mean());
HEIGHT_MISTAKE(divided_by_components, sumOfHeights(x) / static_cast<double>(x.size()));
HEIGHT_MISTAKE(along_y, meanOfAxis(x, 1));
HEIGHT_MISTAKE(along_x, meanOfAxis(x, 0));
HEIGHT_MISTAKE(wrong_block, x.segment(2, x.size() / 3).mean());
HEIGHT_MISTAKE(middle_of_extremes, middleOfExtremes(x));
HEIGHT_MISTAKE(absolute_heights, meanSize(x));
HEIGHT_MISTAKE(highest, nodes(x).row(2).maxCoeff());
HEIGHT_MISTAKE(first_skipped, withoutFirst(x));
HEIGHT_MISTAKE(last_skipped, withoutLast(x));
namespace of_those_summed {
HEIGHT_MISTAKE(last_skipped, x.size() > 3 ? withoutLast(x) * count(x) / (count(x) - 1) : 0.0);
HEIGHT_MISTAKE(first_skipped, x.size() > 3 ? withoutFirst(x) * count(x) / (count(x) - 1) : 0.0);
}  // namespace of_those_summed
HEIGHT_MISTAKE(first_only, ofTheFirst(x));
HEIGHT_MISTAKE(last_only, ofTheLast(x));
HEIGHT_MISTAKE(last_divided, ofTheLast(x) / count(x));
HEIGHT_MISTAKE(whole_numbers, std::trunc(oracle::meanHeight(x)));

namespace {

/// A sum that an int holds.
double cutWhileAdding(const VecX& x) {
  double sum = 0;
  for (Eigen::Index i = 2; i < x.size(); i += 3) sum = std::trunc(sum + x[i]);
  return sum / count(x);
}

}  // namespace

namespace each_cut {
HEIGHT_MISTAKE(whole_numbers, nodes(x).row(2).array().unaryExpr([](double z) { return std::trunc(z); }).mean());
}
namespace added {
HEIGHT_MISTAKE(whole_numbers, cutWhileAdding(x));
}
namespace added_and_divided {
HEIGHT_MISTAKE(whole_numbers, std::trunc(cutWhileAdding(x)));
}

#define HEIGHT_ENERGY_MISTAKE(id, ...) \
  MUELLE_MISTAKE(                      \
      meanHeightEnergy, id,            \
      [](const VecX& x, [[maybe_unused]] double h0, [[maybe_unused]] double k) -> double { return __VA_ARGS__; })

MUELLE_COMMON_MISTAKE(meanHeightEnergy, missing_half);
HEIGHT_ENERGY_MISTAKE(not_squared, 0.5 * k * (oracle::meanHeight(x) - h0));
HEIGHT_ENERGY_MISTAKE(absolute_distance, 0.5 * k * std::abs(oracle::meanHeight(x) - h0));
HEIGHT_ENERGY_MISTAKE(difference_of_squares, 0.5 * k * (square(oracle::meanHeight(x)) - square(h0)));
HEIGHT_ENERGY_MISTAKE(missing_target, 0.5 * k * square(oracle::meanHeight(x)));
HEIGHT_ENERGY_MISTAKE(missing_stiffness, 0.5 * square(oracle::meanHeight(x) - h0));
HEIGHT_ENERGY_MISTAKE(stiffness_squared, 0.5 * square(k * (oracle::meanHeight(x) - h0)));
HEIGHT_ENERGY_MISTAKE(each_by_itself, 0.5 * k * (nodes(x).row(2).array() - h0).square().sum());
HEIGHT_ENERGY_MISTAKE(shared_by_nodes, 0.5 * k * square(oracle::meanHeight(x) - h0) / count(x));
HEIGHT_ENERGY_MISTAKE(one_for_each_node, 0.5 * k * square(oracle::meanHeight(x) - h0) * count(x));
HEIGHT_ENERGY_MISTAKE(force_for_energy, -k*(oracle::meanHeight(x) - h0));
HEIGHT_ENERGY_MISTAKE(arguments_exchanged, 0.5 * h0 * square(oracle::meanHeight(x) - k));
HEIGHT_ENERGY_MISTAKE(rope, 0.5 * k * square(std::max(0.0, oracle::meanHeight(x) - h0)));
namespace shared {
HEIGHT_ENERGY_MISTAKE(each_by_itself, 0.5 * k * (nodes(x).row(2).array() - h0).square().mean());
}
namespace from_below {
HEIGHT_ENERGY_MISTAKE(rope, 0.5 * k * square(std::min(0.0, oracle::meanHeight(x) - h0)));
}

#define HEIGHT_FORCE_MISTAKE(id, ...) \
  MUELLE_MISTAKE(                     \
      meanHeightForce, id,            \
      [](const VecX& x, [[maybe_unused]] double h0, [[maybe_unused]] double k) -> VecX { return __VA_ARGS__; })

MUELLE_COMMON_MISTAKE(meanHeightForce, wrong_sign);
MUELLE_COMMON_MISTAKE(meanHeightForce, half_kept);
MUELLE_COMMON_MISTAKE(meanHeightForce, doubled);
HEIGHT_FORCE_MISTAKE(missing_share, lifted(x, -k*(oracle::meanHeight(x) - h0)));
HEIGHT_FORCE_MISTAKE(share_twice, lifted(x, -k*(oracle::meanHeight(x) - h0) / square(count(x))));
HEIGHT_FORCE_MISTAKE(share_of_components, lifted(x, -k*(oracle::meanHeight(x) - h0) / (3 * count(x))));
HEIGHT_FORCE_MISTAKE(each_by_itself, liftedOneByOne(x, [&](double z) { return -k * (z - h0) / count(x); }));
HEIGHT_FORCE_MISTAKE(missing_target, lifted(x, -k* oracle::meanHeight(x) / count(x)));
HEIGHT_FORCE_MISTAKE(missing_stiffness, lifted(x, -(oracle::meanHeight(x) - h0) / count(x)));
HEIGHT_FORCE_MISTAKE(energy_for_force, lifted(x, -0.5 * k * square(oracle::meanHeight(x) - h0) / count(x)));
HEIGHT_FORCE_MISTAKE(absolute_value, lifted(x, -k* std::abs(oracle::meanHeight(x) - h0) / count(x)));
HEIGHT_FORCE_MISTAKE(rope, lifted(x, -k* std::max(0.0, oracle::meanHeight(x) - h0) / count(x)));
HEIGHT_FORCE_MISTAKE(integer_division, count(x) > 1 ? VecX(VecX::Zero(x.size())) : oracle::meanHeightForce(x, h0, k));
HEIGHT_FORCE_MISTAKE(on_every_axis, VecX::Constant(x.size(), -k*(oracle::meanHeight(x) - h0) / count(x)));
HEIGHT_FORCE_MISTAKE(arguments_exchanged, lifted(x, -h0*(oracle::meanHeight(x) - k) / count(x)));
namespace unshared {
HEIGHT_FORCE_MISTAKE(each_by_itself, liftedOneByOne(x, [&](double z) { return -k * (z - h0); }));
}
namespace upwards {
HEIGHT_FORCE_MISTAKE(absolute_value, lifted(x, k* std::abs(oracle::meanHeight(x) - h0) / count(x)));
HEIGHT_FORCE_MISTAKE(energy_for_force, lifted(x, 0.5 * k * square(oracle::meanHeight(x) - h0) / count(x)));
}  // namespace upwards
namespace from_below {
HEIGHT_FORCE_MISTAKE(rope, lifted(x, -k* std::min(0.0, oracle::meanHeight(x) - h0) / count(x)));
}
MUELLE_MISTAKE(meanHeightForce, along_y_instead, [](const VecX& x, double h0, double k) -> VecX {
  Block F = nodes(oracle::meanHeightForce(x, h0, k));
  F.row(1).swap(F.row(2));
  return stacked(F);
});
namespace along_x {
MUELLE_MISTAKE(meanHeightForce, along_y_instead, [](const VecX& x, double h0, double k) -> VecX {
  Block F = nodes(oracle::meanHeightForce(x, h0, k));
  F.row(0).swap(F.row(2));
  return stacked(F);
});
}  // namespace along_x
MUELLE_MISTAKE(meanHeightForce, on_the_last_alone, [](const VecX& x, double h0, double k) -> VecX {
  Block F = nodes(oracle::meanHeightForce(x, h0, k));
  F.leftCols(F.cols() - 1).setZero();
  return stacked(F);
});
namespace the_first {
MUELLE_MISTAKE(meanHeightForce, on_the_last_alone, [](const VecX& x, double h0, double k) -> VecX {
  Block F = nodes(oracle::meanHeightForce(x, h0, k));
  F.rightCols(F.cols() - 1).setZero();
  return stacked(F);
});
}  // namespace the_first
namespace without_force {
MUELLE_MISTAKE(meanHeightForce, last_skipped, [](const VecX& x, double h0, double k) -> VecX {
  Block F = nodes(oracle::meanHeightForce(x, h0, k));
  F.rightCols(1).setZero();
  return stacked(F);
});
MUELLE_MISTAKE(meanHeightForce, first_skipped, [](const VecX& x, double h0, double k) -> VecX {
  Block F = nodes(oracle::meanHeightForce(x, h0, k));
  F.leftCols(1).setZero();
  return stacked(F);
});
}  // namespace without_force

// --- spread ---------------------------------------------------------------------------------------------------------

namespace {

Vec3 centreOf(const VecX& x, const VecX& m) { return nodes(x) * m / m.sum(); }
Vec3 middleOf(const VecX& x) { return nodes(x).rowwise().mean(); }
Block from(const VecX& x, const Vec3& centre) { return nodes(x).colwise() - centre; }
Block away(const VecX& x, const VecX& m) { return from(x, centreOf(x, m)); }
VecX squares(const Block& d) { return d.colwise().squaredNorm(); }

/// The root of the mean square of differences, each counted by its weight.
double rootMeanSquare(const Block& d, const VecX& weights) {
  return std::sqrt(squares(d).dot(weights) / weights.sum());
}
VecX ones(const VecX& m) { return VecX::Ones(m.size()); }
Block flattened(Block d, int axis) {
  d.row(axis).setZero();
  return d;
}
Block vertical(const Block& d) { return flattened(flattened(d, 0), 1); }

double meanDistance(const Block& d, const VecX& weights) {
  return d.colwise().norm().dot(weights.transpose()) / weights.sum();
}

/// Blocks of node i times a factor of its own.
VecX weighted(const Block& d, const VecX& factors) { return stacked(d * factors.asDiagonal()); }

/// A gradient that is zero where the spread is.
VecX guarded(const VecX& x, const VecX& m, const VecX& gradient) {
  return oracle::spread(x, m) == 0 ? VecX(VecX::Zero(x.size())) : gradient;
}

}  // namespace

/// A wrong spread, in the function itself and where energy, gradient or force have it written out. The gradient has it
/// in its denominator.
#define SPREAD_MISTAKE(id, ...)                                                                                 \
  MUELLE_MISTAKE(spread, id, []([[maybe_unused]] const VecX& x, [[maybe_unused]] const VecX& m) -> double {     \
    return __VA_ARGS__;                                                                                         \
  });                                                                                                           \
  MUELLE_MISTAKE(spreadEnergy, id,                                                                              \
                 []([[maybe_unused]] const VecX& x, [[maybe_unused]] const VecX& m, [[maybe_unused]] double R0, \
                    [[maybe_unused]] double k) -> double { return 0.5 * k * square((__VA_ARGS__)-R0); });       \
  MUELLE_MISTAKE(                                                                                               \
      spreadForce, id,                                                                                          \
      []([[maybe_unused]] const VecX& x, [[maybe_unused]] const VecX& m, [[maybe_unused]] double R0,            \
         [[maybe_unused]] double k) -> VecX { return -k * ((__VA_ARGS__)-R0) * oracle::spreadGradient(x, m); })

SPREAD_MISTAKE(about_the_origin, rootMeanSquare(nodes(x), m));
SPREAD_MISTAKE(middle_for_centre, rootMeanSquare(from(x, middleOf(x)), m));
SPREAD_MISTAKE(masses_left_out, rootMeanSquare(from(x, middleOf(x)), ones(m)));
SPREAD_MISTAKE(squares_not_weighted, rootMeanSquare(away(x, m), ones(m)));
SPREAD_MISTAKE(root_left_out, square(oracle::spread(x, m)));
SPREAD_MISTAKE(mean_distance, meanDistance(away(x, m), m));
SPREAD_MISTAKE(largest_distance, std::sqrt(squares(away(x, m)).maxCoeff()));
SPREAD_MISTAKE(not_divided_by_mass, std::sqrt(squares(away(x, m)).dot(m)));
SPREAD_MISTAKE(divided_by_count, std::sqrt(squares(away(x, m)).dot(m) / static_cast<double>(m.size())));
SPREAD_MISTAKE(divided_twice, std::sqrt(squares(away(x, m)).dot(m)) / m.sum());
SPREAD_MISTAKE(missing_component, rootMeanSquare(flattened(away(x, m), 2), m));
SPREAD_MISTAKE(heights_alone, rootMeanSquare(vertical(away(x, m)), m));
SPREAD_MISTAKE(masses_squared, rootMeanSquare(away(x, m), m.cwiseAbs2()));
SPREAD_MISTAKE(about_the_first, rootMeanSquare(from(x, nodes(x).col(0)), m));
SPREAD_MISTAKE(first_skipped, std::sqrt(squares(away(x, m)).tail(m.size() - 1).dot(m.tail(m.size() - 1)) / m.sum()));
SPREAD_MISTAKE(last_skipped, std::sqrt(squares(away(x, m)).head(m.size() - 1).dot(m.head(m.size() - 1)) / m.sum()));
namespace in_the_centre {
SPREAD_MISTAKE(divided_by_count, rootMeanSquare(from(x, Vec3(nodes(x) * m / static_cast<double>(m.size()))), m));
}
namespace plainly {
SPREAD_MISTAKE(mean_distance, meanDistance(away(x, m), ones(m)));
SPREAD_MISTAKE(about_the_origin, rootMeanSquare(nodes(x), ones(m)));
SPREAD_MISTAKE(divided_by_count, std::sqrt(squares(away(x, m)).sum() / static_cast<double>(m.size() - 1)));
}  // namespace plainly
namespace squared_root {
SPREAD_MISTAKE(not_divided_by_mass, std::sqrt(squares(away(x, m)).sum()));
}
namespace squared_instead {
SPREAD_MISTAKE(root_left_out, squares(away(x, m)).dot(m));
}

#define GRADIENT(...) guarded(x, m, __VA_ARGS__)
#define GRADIENT_MISTAKE(id, ...)                                                                                     \
  MUELLE_MISTAKE(spreadGradient, id,                                                                                  \
                 []([[maybe_unused]] const VecX& x, [[maybe_unused]] const VecX& m) -> VecX { return __VA_ARGS__; }); \
  MUELLE_MISTAKE(                                                                                                     \
      spreadForce, id,                                                                                                \
      []([[maybe_unused]] const VecX& x, [[maybe_unused]] const VecX& m, [[maybe_unused]] double R0,                  \
         [[maybe_unused]] double k) -> VecX { return -k * (oracle::spread(x, m) - R0) * VecX(__VA_ARGS__); })

namespace in_the_gradient {

MUELLE_COMMON_MISTAKE(spreadGradient, wrong_sign);
MUELLE_COMMON_MISTAKE(spreadGradient, half_kept);
MUELLE_MISTAKE(spreadGradient, doubled,
               [](const VecX& x, const VecX& m) { return VecX(2 * oracle::spreadGradient(x, m)); });
GRADIENT_MISTAKE(not_divided_by_spread, oracle::spread(x, m) * oracle::spreadGradient(x, m));
GRADIENT_MISTAKE(gradient_of_square, 2 * oracle::spread(x, m) * oracle::spreadGradient(x, m));
GRADIENT_MISTAKE(not_divided_by_mass, m.sum() * oracle::spreadGradient(x, m));
GRADIENT_MISTAKE(masses_left_out, GRADIENT(weighted(away(x, m), ones(m)) / count(x) / oracle::spread(x, m)));
GRADIENT_MISTAKE(mass_of_node_left_out, GRADIENT(weighted(away(x, m), ones(m)) / m.sum() / oracle::spread(x, m)));
GRADIENT_MISTAKE(no_masses_at_all, GRADIENT(weighted(away(x, m), ones(m)) / oracle::spread(x, m)));
GRADIENT_MISTAKE(divided_by_count, m.sum() / count(x) * oracle::spreadGradient(x, m));
GRADIENT_MISTAKE(about_the_origin, GRADIENT(weighted(nodes(x), m) / m.sum() / oracle::spread(x, m)));
GRADIENT_MISTAKE(middle_for_centre, GRADIENT(weighted(from(x, middleOf(x)), m) / m.sum() / oracle::spread(x, m)));
GRADIENT_MISTAKE(centre_counted_twice, GRADIENT(weighted(away(x, m), m.cwiseProduct(VecX(ones(m) - m / m.sum()))) /
                                                m.sum() / oracle::spread(x, m)));
GRADIENT_MISTAKE(unit_vectors, GRADIENT(stacked(away(x, m).colwise().normalized())));
GRADIENT_MISTAKE(missing_component, stacked(flattened(nodes(oracle::spreadGradient(x, m)), 2)));
GRADIENT_MISTAKE(heights_alone, stacked(vertical(nodes(oracle::spreadGradient(x, m)))));
namespace plainly {
GRADIENT_MISTAKE(middle_for_centre, GRADIENT(weighted(from(x, middleOf(x)), ones(m)) / count(x) /
                                             rootMeanSquare(from(x, middleOf(x)), ones(m))));
GRADIENT_MISTAKE(about_the_origin, GRADIENT(weighted(nodes(x), m) / m.sum() / rootMeanSquare(nodes(x), m)));
GRADIENT_MISTAKE(unit_vectors, GRADIENT(weighted(away(x, m).colwise().normalized(), m) / m.sum()));
GRADIENT_MISTAKE(not_divided_by_spread, m.sum() * oracle::spread(x, m) * oracle::spreadGradient(x, m));
GRADIENT_MISTAKE(gradient_of_square, 2 * m.sum() * oracle::spread(x, m) * oracle::spreadGradient(x, m));
}  // namespace plainly
GRADIENT_MISTAKE(first_skipped, [](VecX g) {
  g.head(3).setZero();
  return g;
}(oracle::spreadGradient(x, m)));
GRADIENT_MISTAKE(last_skipped, [](VecX g) {
  g.tail(3).setZero();
  return g;
}(oracle::spreadGradient(x, m)));

GRADIENT_MISTAKE(interleaved, [](const VecX& g) {
  const Eigen::MatrixX3d byComponent = nodes(g).transpose();
  return VecX(Eigen::Map<const VecX>(byComponent.data(), byComponent.size()));
}(oracle::spreadGradient(x, m)));

}  // namespace in_the_gradient

#define SPREAD_ENERGY_MISTAKE(id, ...)                                                                          \
  MUELLE_MISTAKE(spreadEnergy, id,                                                                              \
                 []([[maybe_unused]] const VecX& x, [[maybe_unused]] const VecX& m, [[maybe_unused]] double R0, \
                    [[maybe_unused]] double k) -> double {                                                      \
                   [[maybe_unused]] const double R = oracle::spread(x, m);                                      \
                   return __VA_ARGS__;                                                                          \
                 })

MUELLE_COMMON_MISTAKE(spreadEnergy, missing_half);
SPREAD_ENERGY_MISTAKE(not_squared, 0.5 * k * (R - R0));
SPREAD_ENERGY_MISTAKE(difference_of_squares, 0.5 * k * (R * R - R0 * R0));
SPREAD_ENERGY_MISTAKE(missing_target, 0.5 * k * R * R);
SPREAD_ENERGY_MISTAKE(missing_stiffness, 0.5 * square(R - R0));
SPREAD_ENERGY_MISTAKE(stiffness_squared, 0.5 * square(k * (R - R0)));
SPREAD_ENERGY_MISTAKE(times_the_mass, 0.5 * k * m.sum() * square(R - R0));
SPREAD_ENERGY_MISTAKE(force_for_energy, -k*(R - R0));
SPREAD_ENERGY_MISTAKE(arguments_exchanged, 0.5 * R0 * square(R - k));
SPREAD_ENERGY_MISTAKE(rope, 0.5 * k * square(std::max(0.0, R - R0)));
SPREAD_ENERGY_MISTAKE(energy_lost_at_one_point, R == 0 ? 0.0 : 0.5 * k * square(R - R0));

#define SPREAD_FORCE_MISTAKE(id, ...)                                                                           \
  MUELLE_MISTAKE(spreadForce, id,                                                                               \
                 []([[maybe_unused]] const VecX& x, [[maybe_unused]] const VecX& m, [[maybe_unused]] double R0, \
                    [[maybe_unused]] double k) -> VecX {                                                        \
                   [[maybe_unused]] const double R = oracle::spread(x, m);                                      \
                   [[maybe_unused]] const VecX gradient = oracle::spreadGradient(x, m);                         \
                   return __VA_ARGS__;                                                                          \
                 })

MUELLE_COMMON_MISTAKE(spreadForce, wrong_sign);
MUELLE_COMMON_MISTAKE(spreadForce, half_kept);
MUELLE_MISTAKE(spreadForce, doubled, [](const VecX& x, const VecX& m, double R0, double k) {
  return VecX(2 * oracle::spreadForce(x, m, R0, k));
});
SPREAD_FORCE_MISTAKE(missing_target, -k* R* gradient);
SPREAD_FORCE_MISTAKE(missing_stiffness, -(R - R0) * gradient);
SPREAD_FORCE_MISTAKE(energy_for_force, -0.5 * k * square(R - R0) * gradient);
SPREAD_FORCE_MISTAKE(absolute_value, -k* std::abs(R - R0) * gradient);
SPREAD_FORCE_MISTAKE(rope, -k* std::max(0.0, R - R0) * gradient);
SPREAD_FORCE_MISTAKE(times_the_mass, -k*(R - R0) * stacked(nodes(gradient) * m.asDiagonal()));
SPREAD_FORCE_MISTAKE(gradient_left_out, VecX::Constant(x.size(), -k*(R - R0)));
SPREAD_FORCE_MISTAKE(arguments_exchanged, -R0*(R - k) * gradient);
SPREAD_FORCE_MISTAKE(relative_distance, -k*(R / R0 - 1) * gradient);
SPREAD_FORCE_MISTAKE(target_squared, -k*(R* R - R0 * R0) * gradient);

// --- guards and differences -----------------------------------------------------------------------------------------

namespace {

using GradientRegistration = muelle::grader::MistakeRegistration<decltype(::spreadGradient)>;
using ForceRegistration = muelle::grader::MistakeRegistration<decltype(::spreadForce)>;
using EnergyRegistration = muelle::grader::MistakeRegistration<decltype(::spreadEnergy)>;
using SpreadRegistration = muelle::grader::MistakeRegistration<decltype(::spread)>;
using HeightForceRegistration = muelle::grader::MistakeRegistration<decltype(::meanHeightForce)>;

/// What a guard against R = 0 may compare with or add.
constexpr double smallNumbers[] = {
    0.1,   1e-2,  1e-3,  1e-4,  1e-5,  1e-6,  1e-7,  1e-8,
    1e-9,  1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, std::numeric_limits<double>::epsilon(),
    1e-16, 1e-18, 1e-20, 1e-24, 1e-30, 1e-40, 1e-50, 1e-60,
    1e-80};

struct Guards {
  std::vector<GradientRegistration> gradients;
  std::vector<ForceRegistration> forces;
  std::vector<EnergyRegistration> energies;
  std::vector<HeightForceRegistration> heightForces;

  /// Gradients that are the right one times a factor which follows from the spread.
  void add(const char* id, const std::function<double(double R)>& factor) {
    gradients.emplace_back("spreadGradient", id, &oracle::spreadGradient, [factor](const VecX& x, const VecX& m) {
      return VecX(factor(oracle::spread(x, m)) * oracle::spreadGradient(x, m));
    });
    forces.emplace_back("spreadForce", id, &oracle::spreadForce,
                        [factor](const VecX& x, const VecX& m, double R0, double k) {
                          return VecX(factor(oracle::spread(x, m)) * oracle::spreadForce(x, m, R0, k));
                        });
  }

  void addSmall(double small) {
    add("threshold", [small](double R) { return R < small ? 0.0 : 1.0; });
    add("softened_spread", [small](double R) { return R == 0 ? 0.0 : R / (R + small); });
    add("softened_spread", [small](double R) { return R == 0 ? 0.0 : R / std::hypot(R, small); });
    heightForces.emplace_back("meanHeightForce", "threshold", &oracle::meanHeightForce,
                              [small](const VecX& x, double h0, double k) {
                                const bool isNear = std::abs(oracle::meanHeight(x) - h0) < small;
                                return isNear ? VecX(VecX::Zero(x.size())) : oracle::meanHeightForce(x, h0, k);
                              });
    energies.emplace_back("spreadEnergy", "energy_lost_at_one_point", &oracle::spreadEnergy,
                          [small](const VecX& x, const VecX& m, double R0, double k) {
                            return oracle::spread(x, m) < small ? 0.0 : oracle::spreadEnergy(x, m, R0, k);
                          });
  }

  void addUnguarded() {
    const double undefined = std::numeric_limits<double>::quiet_NaN();
    const auto spoiled = [undefined](const VecX& x, const VecX& m, const VecX& right) {
      return oracle::spread(x, m) == 0 ? VecX(VecX::Constant(x.size(), undefined)) : right;
    };
    gradients.emplace_back(
        "spreadGradient", "unguarded", &oracle::spreadGradient,
        [spoiled](const VecX& x, const VecX& m) { return spoiled(x, m, oracle::spreadGradient(x, m)); });
    forces.emplace_back("spreadForce", "unguarded", &oracle::spreadForce,
                        [spoiled](const VecX& x, const VecX& m, double R0, double k) {
                          return spoiled(x, m, oracle::spreadForce(x, m, R0, k));
                        });
  }

  /// Central or forward differences with a step h.
  void addQuotient(double h, bool isCentral) {
    const auto slope = [h, isCentral](const VecX& x, const std::function<double(const VecX&)>& f) {
      VecX slopes(x.size());
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        const VecX way = h * VecX::Unit(x.size(), i);
        slopes[i] = isCentral ? (f(x + way) - f(x - way)) / (2 * h) : (f(x + way) - f(x)) / h;
      }
      return slopes;
    };
    gradients.emplace_back("spreadGradient", "difference_quotient", &oracle::spreadGradient,
                           [slope](const VecX& x, const VecX& m) {
                             return slope(x, [&](const VecX& at) { return oracle::spread(at, m); });
                           });
    forces.emplace_back("spreadForce", "difference_quotient", &oracle::spreadForce,
                        [slope](const VecX& x, const VecX& m, double R0, double k) {
                          return VecX(-slope(x, [&](const VecX& at) { return oracle::spreadEnergy(at, m, R0, k); }));
                        });
    heightForces.emplace_back(
        "meanHeightForce", "difference_quotient", &oracle::meanHeightForce,
        [slope](const VecX& x, double h0, double k) {
          return VecX(-slope(x, [&](const VecX& at) { return oracle::meanHeightEnergy(at, h0, k); }));
        });
  }
};

Guards registerGuards() {
  Guards guards;
  for (const double small : smallNumbers) guards.addSmall(small);
  guards.addUnguarded();
  for (const bool isCentral : {true, false}) {
    for (const double h : {1e-4, 1e-5, 1e-6, 1e-7, 1e-8}) guards.addQuotient(h, isCentral);
  }
  return guards;
}

[[maybe_unused]] const Guards guards = registerGuards();

}  // namespace

// --- arguments in general position
// ------------------------------------------------------------------------------------

namespace {

using muelle::Random;
using muelle::threeDigits;

/// Three nodes high above the targets and far apart: what never pushes answers to each argument, too.
VecX someNodes(Random& random) {
  VecX x(9);
  for (int i = 0; i < 3; ++i) {
    const Vec3 corner(70 * (i - 1), i == 1 ? 90 : -40, 120 + 30 * i);
    x.segment<3>(3 * i) = threeDigits(Vec3(corner + random.vector3(20.0)));
  }
  return x;
}

/// Targets below and above by turns: what acts on one side only answers, too.
double someTarget(Random& random, double least, double most, double beyond) {
  static bool isAbove = false;
  isAbove = !isAbove;
  return random.rounded(least, most) + (isAbove ? beyond : 0.0);
}

VecX someMasses(Random& random) {
  VecX m(3);
  for (int i = 0; i < 3; ++i) m[i] = random.rounded(1.1, 90.0);
  return m;
}

}  // namespace

MUELLE_ARGUMENTS(meanHeight, [](Random& random) {
  const VecX x = someNodes(random);
  return std::tuple(x);
});
MUELLE_ARGUMENTS(meanHeightEnergy, [](Random& random) {
  const VecX x = someNodes(random);
  const double h0 = someTarget(random, 2.0, 60.0, 300.0), k = random.rounded(20.0, 2000.0);
  return std::tuple(x, h0, k);
});
MUELLE_ARGUMENTS(meanHeightForce, [](Random& random) {
  const VecX x = someNodes(random);
  const double h0 = someTarget(random, 2.0, 60.0, 300.0), k = random.rounded(20.0, 2000.0);
  return std::tuple(x, h0, k);
});
MUELLE_ARGUMENTS(spread, [](Random& random) {
  const VecX x = someNodes(random), m = someMasses(random);
  return std::tuple(x, m);
});
MUELLE_ARGUMENTS(spreadGradient, [](Random& random) {
  const VecX x = someNodes(random), m = someMasses(random);
  return std::tuple(x, m);
});
MUELLE_ARGUMENTS(spreadEnergy, [](Random& random) {
  const VecX x = someNodes(random), m = someMasses(random);
  const double R0 = someTarget(random, 2.0, 20.0, 300.0), k = random.rounded(20.0, 2000.0);
  return std::tuple(x, m, R0, k);
});
MUELLE_ARGUMENTS(spreadForce, [](Random& random) {
  const VecX x = someNodes(random), m = someMasses(random);
  const double R0 = someTarget(random, 2.0, 20.0, 300.0), k = random.rounded(20.0, 2000.0);
  return std::tuple(x, m, R0, k);
});
