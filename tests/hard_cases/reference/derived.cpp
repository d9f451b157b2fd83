#include "reference/derived.h"

#include "reference/gragg_bulirsch_stoer.h"

#include <array>

namespace muelle::hard_cases {

namespace {

const Quad pi = quad("3.14159265358979323846264338327950288419716939937510");
const Quad earth = quad("9.81");

void circle(std::vector<Derived>& all) {
  const Quad r = quad("0.8175"), angle = 40;
  all.push_back({"H06", "omega", quad("3.27") / r});
  all.push_back({"H06", "x(10)", r * cosq(angle)});
  all.push_back({"H06", "y(10)", r * sinq(angle)});
  all.push_back({"H06", "z(10)", quad("-0.613125")});
  all.push_back({"H06", "vx(10)", -quad("3.27") * sinq(angle)});
  all.push_back({"H06", "vy(10)", quad("3.27") * cosq(angle)});
  all.push_back({"H06", "Lz", r * quad("3.27")});
  const Quad speed = quad("3.27"), z = quad("-0.613125"), stretch = sqrtq(r * r + z * z) - quad("0.858375");
  all.push_back({"H06", "E", speed * speed / 2 + earth * z + 50 * stretch * stretch});
}

/// Angular frequency of mode j of the chain of 50 with stiffness c between neighbours of mass 1.
Quad chainFrequency(Quad c, int j) { return 2 * sqrtq(c) * sinq(j * pi / 102); }

void chain(std::vector<Derived>& all) {
  const Quad along = 100, across = 100 * quad("0.1") / quad("1.1");
  all.push_back({"H10", "longitudinal.omega1", chainFrequency(along, 1)});
  all.push_back({"H10", "longitudinal.omega50", chainFrequency(along, 50)});
  all.push_back({"H10", "transverse.omega1", chainFrequency(across, 1)});
  all.push_back({"H10", "transverse.omega50", chainFrequency(across, 50)});
  for (const int i : {1, 13, 25, 50}) {
    const Quad u = (sinq(i * pi / 51) * cosq(10 * chainFrequency(along, 1)) +
                    sinq(50 * i * pi / 51) * cosq(10 * chainFrequency(along, 50))) /
                   100;
    all.push_back({"H10", "longitudinal.u" + std::to_string(i) + "(10)", u});
    const Quad omega = chainFrequency(across, 1), shape = sinq(i * pi / 51) / 1000000;
    all.push_back({"H10", "transverse.z" + std::to_string(i) + "(10)", shape * cosq(10 * omega)});
    all.push_back({"H10", "transverse.vz" + std::to_string(i) + "(10)", -shape * omega * sinq(10 * omega)});
  }
}

/// The wave across the chain with nothing neglected: 50 nodes in the plane, x from the place in the line and z, both in
/// micrometres, so that the integrator's tolerance is one of the wave.
void chainWithoutLinearisation(std::vector<Derived>& all, Quad tolerance) {
  constexpr std::size_t n = 50;
  const Quad micro = quad("1e-6"), spacing = quad("1.1");
  // y = x_1 .. x_50, z_1 .. z_50, then their velocities.
  const Slope slope = [&](Quad, const QuadVector& y, QuadVector& f) {
    for (std::size_t i = 0; i < 2 * n; ++i) f[i] = y[2 * n + i];
    for (std::size_t i = 2 * n; i < 4 * n; ++i) f[i] = 0;
    for (std::size_t j = 0; j <= n;
         ++j) {  // spring j holds nodes j - 1 and j, of which the first and the last are fixed
      const Quad dx = spacing + micro * ((j < n ? y[j] : 0) - (j > 0 ? y[j - 1] : 0));
      const Quad dz = micro * ((j < n ? y[n + j] : 0) - (j > 0 ? y[n + j - 1] : 0));
      const Quad pull = 100 * (1 - 1 / sqrtq(dx * dx + dz * dz)) / micro;  // 1/micro: forces in the units of y
      // The line's own tension cancels at every node; without it nothing is lost to cancellation.
      const Quad fx = pull * dx - 10 / micro, fz = pull * dz;
      if (j < n) f[2 * n + j] -= fx, f[3 * n + j] -= fz;
      if (j > 0) f[2 * n + j - 1] += fx, f[3 * n + j - 1] += fz;
    }
  };
  QuadVector y(4 * n, 0);
  for (std::size_t i = 0; i < n; ++i) y[n + i] = sinq(static_cast<int>(i + 1) * pi / 51);
  y = integrate(slope, y, 0, 10, tolerance);
  for (const std::size_t i : {1U, 13U, 25U, 50U}) {
    const std::string node = std::to_string(i) + "(10)";
    all.push_back({"H10", "transverse.nonlinear.z" + node, micro * y[n + i - 1]});
    all.push_back({"H10", "transverse.nonlinear.vz" + node, micro * y[3 * n + i - 1]});
  }
}

void heavyBelowLightInOneDimension(std::vector<Derived>& all) {
  const Quad k = 100000000, m1 = 1, m2 = 1000000;
  const Quad z1 = -(1 + (m1 + m2) * earth / k), z2 = z1 - 1 - m2 * earth / k;
  all.push_back({"H12", "static.z1", z1});
  all.push_back({"H12", "static.z2", z2});
  // u'' = -A u, A = [[2k/m1, -k/m1], [-k/m2, k/m2]]: eigenvalues by the stable form of the quadratic.
  const Quad trace = 2 * k / m1 + k / m2, determinant = k / m1 * (k / m2);
  const Quad fast = (trace + sqrtq(trace * trace - 4 * determinant)) / 2, slow = determinant / fast;
  all.push_back({"H12", "omega_fast", sqrtq(fast)});
  all.push_back({"H12", "omega_slow", sqrtq(slow)});
  // Eigenvectors (1, q): second row, -k/m2 + (k/m2 - lambda) q = 0.
  const Quad qFast = k / m2 / (k / m2 - fast), qSlow = k / m2 / (k / m2 - slow);
  const Quad u1 = -1 - z1, u2 = -2 - z2;
  const Quad aSlow = (u2 - qFast * u1) / (qSlow - qFast), aFast = u1 - aSlow;
  const Quad cSlow = aSlow * cosq(sqrtq(slow)), cFast = aFast * cosq(sqrtq(fast));
  all.push_back({"H12", "one_d.z1(1)", z1 + cSlow + cFast});
  all.push_back({"H12", "one_d.z2(1)", z2 + qSlow * cSlow + qFast * cFast});
  all.push_back({"H12", "one_d.period", 2 * pi / sqrtq(slow)});
  all.push_back({"H12", "one_d.period_fast", 2 * pi / sqrtq(fast)});
  all.push_back({"H12", "one_d.E", -earth * (m1 + 2 * m2)});  // at rest lengths: gravity alone
  const Quad upper = -1 - z1, lower = z1 - z2 - 1;
  all.push_back({"H12", "static.E", earth * (m1 * z1 + m2 * z2) + k / 2 * (upper * upper + lower * lower)});
}

void heavyBelowLightSwings(std::vector<Derived>& all, Quad tolerance) {
  const Quad k = 100000000, m1 = 1, m2 = 1000000;
  // y = x1 z1 x2 z2, then their velocities.
  const Slope slope = [&](Quad, const QuadVector& y, QuadVector& f) {
    const Quad ux = y[2] - y[0], uz = y[3] - y[1];
    const Quad l1 = sqrtq(y[0] * y[0] + y[1] * y[1]), l2 = sqrtq(ux * ux + uz * uz);
    const Quad s1 = k * (1 - 1 / l1), s2 = k * (1 - 1 / l2);
    for (std::size_t i = 0; i < 4; ++i) f[i] = y[4 + i];
    f[4] = (-s1 * y[0] + s2 * ux) / m1;
    f[5] = (-s1 * y[1] + s2 * uz) / m1 - earth;
    f[6] = -s2 * ux / m2;
    f[7] = -s2 * uz / m2 - earth;
  };
  const QuadVector y =
      integrate(slope, {quad("0.6"), quad("-0.8"), quad("1.2"), quad("-1.6"), 0, 0, 0, 0}, 0, 1, tolerance);
  const std::array<const char*, 8> names = {"x1", "z1", "x2", "z2", "vx1", "vz1", "vx2", "vz2"};
  for (std::size_t i = 0; i < 8; ++i) all.push_back({"H12", std::string("swing.") + names[i] + "(1)", y[i]});
  all.push_back({"H12", "swing.E", -earth * (m1 * quad("0.8") + m2 * quad("1.6"))});
}

constexpr int halfWidthNumerator = 3, halfWidthDenominator = 4;  // w = 3/4

const Quad restLength = Quad(5) / 4;

Quad sideLength(Quad y) {
  const Quad w = Quad(halfWidthNumerator) / halfWidthDenominator;
  return sqrtq(w * w + y * y);
}

/// Energies of the inverted triangle's springs and of its area [J].
Quad springEnergy(Quad y) {
  const Quad stretch = sideLength(y) - restLength;
  return 10 * stretch * stretch;
}
Quad areaEnergy(Quad y, Quad ka) {
  const Quad w = Quad(halfWidthNumerator) / halfWidthDenominator, off = w * (y - 1);
  return ka / 2 * off * off;
}

/// Force -E'(y) of the inverted triangle's free node, mass 1.
Quad triangleForce(Quad y, Quad ka) {
  const Quad w = Quad(halfWidthNumerator) / halfWidthDenominator, L = sideLength(y);
  return -20 * (L - restLength) * y / L - ka * w * w * (y - 1);
}

/// Where `value` changes its sign between `low` and `high`, by bisection to the last bit.
template <class Function>
Quad zeroOf(const Function& value, Quad low, Quad high) {
  const bool lowPositive = value(low) > 0;
  for (int i = 0; i < 120; ++i) {
    const Quad middle = (low + high) / 2;
    ((value(middle) > 0) == lowPositive ? low : high) = middle;
  }
  return low;
}

/// The state at a time, and into what its energy is divided.
void triangleAt(std::vector<Derived>& all, const std::string& time, const QuadVector& y) {
  all.push_back({"H15", "y(" + time + ")", y[0]});
  all.push_back({"H15", "v(" + time + ")", y[1]});
  all.push_back({"H15", "E.kinetic(" + time + ")", y[1] * y[1] / 2});
  all.push_back({"H15", "E.springs(" + time + ")", springEnergy(y[0])});
  all.push_back({"H15", "E.area(" + time + ")", areaEnergy(y[0], 100)});
}

void invertedTriangleMoves(std::vector<Derived>& all, Quad tolerance) {
  all.push_back({"H15", "force_t0", triangleForce(-1, 100)});
  const Quad start = springEnergy(-1) + areaEnergy(-1, 100);
  all.push_back({"H15", "E", start});
  const Slope slope = [](Quad, const QuadVector& y, QuadVector& f) {
    f[0] = y[1];
    f[1] = triangleForce(y[0], 100);
  };
  QuadVector y = {-1, 0};
  Quad from = 0;
  for (const char* time : {"0.1", "0.5", "1"}) {
    y = integrate(slope, y, from, quad(time), tolerance);
    from = quad(time);
    triangleAt(all, time, y);
  }
  // The other end of the swing, where all the energy is potential again.
  all.push_back(
      {"H15", "y_top", zeroOf([&](Quad at) { return springEnergy(at) + areaEnergy(at, 100) - start; }, 1, 4)});
}

void invertedTriangleRests(std::vector<Derived>& all) {
  // ka(y) = 2 k s(y) / (w^2 (1 - y)), s = y (1 - L0/L), s' = 1 - L0/L + L0 y^2/L^3; extremal where
  // s' (1 - y) + s = 0, between the flat state y = 0 and the relaxed inverted one y = -1.
  const Quad w = Quad(halfWidthNumerator) / halfWidthDenominator;
  const auto s = [](Quad at) { return at * (1 - restLength / sideLength(at)); };
  const auto slopeOfKa = [&](Quad at) {
    const Quad L = sideLength(at);
    return (1 - restLength / L + restLength * at * at / (L * L * L)) * (1 - at) + s(at);
  };
  const Quad y = zeroOf(slopeOfKa, -1, quad("-0.01")), ka = 20 * s(y) / (w * w * (1 - y));
  all.push_back({"H15", "y_critical", y});
  all.push_back({"H15", "ka_critical", ka});
  all.push_back({"H15", "E_critical", springEnergy(y) + areaEnergy(y, ka)});
  const Quad inverted = zeroOf([](Quad at) { return triangleForce(at, 4); }, -1, y);
  all.push_back({"H15", "y_inverted(ka=4)", inverted});
  all.push_back({"H15", "E_inverted(ka=4)", springEnergy(inverted) + areaEnergy(inverted, 4)});
}

void friction(std::vector<Derived>& all) {
  const Quad mu = Quad(1) / 2;
  for (const char* degrees : {"26.5", "26.6", "30"}) {
    const Quad angle = quad(degrees) * pi / 180;
    const Quad a = fmaxq(Quad(0), earth * (sinq(angle) - mu * cosq(angle)));
    all.push_back({"H20", std::string("acceleration(") + degrees + ")", a});
    all.push_back({"H20", std::string("slide(") + degrees + ")", 50 * a});
  }
  all.push_back({"H20", "threshold_degrees", atanq(mu) * 180 / pi});
  all.push_back({"H20", "flat.acceleration", -mu * earth});
  all.push_back({"H20", "flat.t_stop", 3 / (mu * earth)});
  all.push_back({"H20", "flat.distance", Quad(9) / (2 * mu * earth)});
}

void pulse(std::vector<Derived>& all) {
  const Quad duration = Quad(1) / 1000, a = 1000;
  all.push_back({"H22", "v(2)", a * duration});
  all.push_back({"H22", "x(2)", a * duration * duration / 2 + a * duration * (1 - duration)});
}

}  // namespace

std::vector<Derived> derivedReferences(Quad tolerance) {
  std::vector<Derived> all;
  circle(all);
  chain(all);
  chainWithoutLinearisation(all, tolerance);
  heavyBelowLightInOneDimension(all);
  heavyBelowLightSwings(all, tolerance);
  invertedTriangleMoves(all, tolerance);
  invertedTriangleRests(all);
  friction(all);
  pulse(all);
  return all;
}

QuadVector elasticPendulum(Quad k, Quad x, Quad z, Quad duration, Quad tolerance) {
  const Slope slope = [k](Quad, const QuadVector& y, QuadVector& f) {
    const Quad L = sqrtq(y[0] * y[0] + y[1] * y[1]);
    f[0] = y[2];
    f[1] = y[3];
    f[2] = -k * (1 - 1 / L) * y[0];
    f[3] = -k * (1 - 1 / L) * y[1] - earth;
  };
  return integrate(slope, {x, z, 0, 0}, 0, duration, tolerance);
}

}  // namespace muelle::hard_cases
