/// \file
/// The true verdicts: implementations are compared with formulas at questions of every kind. These are written in other
/// ways than the solutions of the earlier exercises, and than the questions of this one's.

#include "catch_the_mistake.h"

#include <exception>

namespace {

using muelle::VecX;

/// Something that is no number, or too far off by the numbers involved.
bool isOff(const VecX& got, const VecX& expected, double scale) {
  return !((got - expected).cwiseAbs().maxCoeff() <= 1e-8 * scale);
}

VecX one(double number) { return VecX::Constant(1, number); }

/// Lengths over rest lengths, and stiffnesses, that everything is asked at.
const std::vector<double> lengths = {0.23, 0.7, 1.3, 4.1, 170};
const std::vector<double> restLengths = {0, 0.37, 0.9, 1.9, 6.3};
const std::vector<double> stiffnesses = {0.7, 31, 2e5};

/// From a centimetre down to the shortest of the contract.
std::vector<double> shortLengths() {
  std::vector<double> ladder = {2e-2, 3e-3, 2e-4, 3e-6, 7e-8};
  for (double length = 3e-9; length > 1e-100; length *= 1e-4) ladder.push_back(length);
  ladder.push_back(1e-100);
  return ladder;
}

const Vec3 point(0.6, -1.7, 2.3), axis = Vec3(2, -6, 3) / 7;

bool answersTruly(const std::function<bool()>& isTrue) {
  try {
    return isTrue();
  } catch (const std::exception&) {
    return false;
  }
}

Vec6 ends(const Vec3& xa, const Vec3& xb) { return (Vec6() << xa, xb).finished(); }

}  // namespace

namespace oracle {

bool isSpringForceRight(const SpringForce& f) {
  // The force towards +x: on the upper node it is k (L0 - L).
  const auto isTrueAt = [&f](double from, double L, double k, double L0) {
    const double push = L > 0 ? k * (L0 - L) : 0.0;
    const double scale = k * (L + L0);
    return !isOff(one(f(from + L, from, k, L0)), one(push), scale) &&
           !isOff(one(f(from, from + L, k, L0)), one(-push), scale);
  };
  return answersTruly([&] {
    for (const double k : stiffnesses) {
      for (const double L0 : restLengths) {
        for (const double L : lengths) {
          if (!isTrueAt(0, L, k, L0)) return false;
        }
      }
    }
    for (const double L : shortLengths()) {
      if (!isTrueAt(0, L, 40, 0.3)) return false;
    }
    return isTrueAt(-12.5, 0, 40, 0.3) && isTrueAt(0, 0, 3, 2);
  });
}

bool isGradientRight(const SpringEnergy& energy, const EnergyGradient& gradient) {
  const auto isTrueAt = [&](const Vec3& at, const Vec3& along, double L, double k, double L0) {
    const Vec6 x = ends(at + L * along, at);
    const double stretch = L - L0, scale = k * (L + L0);
    const Vec6 slope = L > 0 ? Vec6(k * stretch * ends(along, -along)) : Vec6(Vec6::Zero());
    return !isOff(one(energy(x, k, L0)), one(k / 2 * stretch * stretch), scale * (L + L0)) &&
           !isOff(gradient(x, k, L0), slope, scale);
  };
  return answersTruly([&] {
    for (const double L0 : restLengths) {
      for (const double L : lengths) {
        if (!isTrueAt(point, axis, L, 31, L0)) return false;
      }
    }
    for (const double k : stiffnesses) {
      if (!isTrueAt(point, axis, 1.9, k, 0.4)) return false;
    }
    for (const double L : shortLengths()) {
      if (!isTrueAt(Vec3::Zero(), axis, L, 40, 0.3)) return false;
    }
    return isTrueAt(point, Vec3::UnitX(), 1.3, 31, 0.9) && isTrueAt(point, Vec3::UnitZ(), 1.3, 31, 0.9) &&
           isTrueAt(point, axis, 0, 40, 0.3);
  });
}

bool isDampingRight(const ProjectedDamping& f) {
  const auto isTrueAt = [&f](const Vec3& xb, double L, const Vec3& va, const Vec3& vb, double d) {
    const Vec3 part = L > 0 ? Vec3((axis * axis.transpose()) * (vb - va)) : Vec3(Vec3::Zero());
    return !isOff(f(xb + L * axis, xb, va, vb, d), d * part, d * (va - vb).norm());
  };
  const Vec3 va(0.7, 1.9, -2.3), vb(-1.1, 0.4, 0.6);
  return answersTruly([&] {
    for (const double L : lengths) {
      for (const double d : {0.3, 7.0}) {
        if (!isTrueAt(point, L, va, vb, d) || !isTrueAt(point, L, vb, va, d)) return false;
      }
    }
    for (const double L : shortLengths()) {
      if (!isTrueAt(Vec3::Zero(), L, vb, va, 3)) return false;
    }
    return isTrueAt(point, 1.3, 2 * axis, -axis, 3) && isTrueAt(point, 0, va, vb, 3);
  });
}

}  // namespace oracle
