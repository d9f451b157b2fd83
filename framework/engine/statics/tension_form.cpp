#include "engine/statics/tension_form.h"

#include "engine/forces/length.h"
#include "engine/solve/dense.h"
#include "engine/solve/linear_solver.h"
#include "engine/statics/at_rest.h"

#include <algorithm>
#include <cmath>
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <limits>

namespace muelle::engine {

namespace {

using Vector = Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;
using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr double eps = std::numeric_limits<double>::epsilon();
/// rho over the largest T/L, and k over rho from which on a tension is an unknown: below, the positions know it to
/// 1e-16 x 100 and the matrix is as good without.
constexpr double kept = 10.0;
constexpr double stiff = 10.0;
/// A shift of the matrix that holds back free motions, over its largest entry.
constexpr double slight = 1e-9;
/// A balance that round-off spoils more than this, of the largest force, is none.
constexpr double trusted = 1e-6;
/// Strains below are round-off of the positions: there are no tensions to be solved for.
constexpr double leastStrain = 1e-14;
/// Each is one linear system; eight bring a chain five times as long as its span to 1e-5 of its length.
constexpr int densityPasses = 8;

/// a - b as the nearest double and the rest (Knuth, TAOCP 2, 4.2.2).
double difference(double a, double b, double& rest) {
  const double s = a - b;
  const double part = s - a;
  rest = (a - (s - part)) + (-b - part);
  return s;
}

/// Columns made orthonormal, twice over for the digits (modified Gram-Schmidt).
void orthonormalise(MatX& Y) {
  for (Eigen::Index c = 0; c < Y.cols(); ++c) {
    for (int pass = 0; pass < 2; ++pass) {
      for (Eigen::Index before = 0; before < c; ++before) Y.col(c) -= Y.col(before).dot(Y.col(c)) * Y.col(before);
      const double size = Y.col(c).norm();
      if (size > 0.0) Y.col(c) /= size;
    }
  }
}

/// A spring with at least one free node.
struct Line {
  std::size_t spring = 0;  // in the model
  int a = -1, b = -1;      // first unknown of the node; -1: fixed, at
  Vec3 fixedA = Vec3::Zero(), fixedB = Vec3::Zero();
  double k = 0.0, L0 = 0.0;
  bool onlyPushes = false;
  bool mixed = false;     // whether S is an unknown
  double rho = 0.0;       // [N/m] left to the positions
  int row = -1;           // of S in the matrix
  double S = 0.0;         // unknown part of the tension [N]
  double L = 0.0;         // length [m]
  Vec3 n = Vec3::Zero();  // from b to a

  bool acts() const { return k > 0.0 && L > 0.0 && (!onlyPushes || L < L0); }
  double tension() const {
    if (!acts()) return 0.0;
    return mixed ? S + rho * (L - L0) : k * (L - L0);
  }
  double stiffness() const { return mixed ? rho : k; }
  double lengthError() const { return mixed ? (L - L0) - S / (k - rho) : 0.0; }
};

std::unique_ptr<ModelSystem> withoutSprings(const ModelSystem& system) {
  Model model = system.model();
  // Kept with no stiffness: so the unknowns have the numbers, and the matrix the pattern, of the whole.
  for (ModelSpring& spring : model.springs) spring.k = 0.0;
  return build(model);
}

}  // namespace

struct TensionForm::Parts {
  Parts(const ModelSystem& whole, const State& state);

  const ModelSystem& system;
  std::unique_ptr<ModelSystem> others;  // everything but the springs
  AtRest still;                         // that, with its external forces as dead loads
  State start;
  int dimension;
  std::vector<int> axes;
  Eigen::Index size;
  Vector hi, lo;  // positions: hi + lo
  std::vector<Line> lines;
  Vector otherForce;
  std::vector<double> F, zero;
  Vector floor;    // what round-off does to F
  SystemMatrix K;  // of the others
  Vector otherFloor;
  Sparse matrix;
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt;
  std::vector<int> rowOf;  // of each unknown in the matrix
  std::vector<int> lowRankRow;
  Eigen::Index rows = 0;
  bool laidOut = false;
  bool analysed = false;
  double load = 0.0;
  double typicalLength = 1.0;
  Work work;
  struct Found {
    bool usable = false;
    int negative = 0;
  };

  Vec3 at(int unknown, const Vec3& fixed) const;
  void measure();
  void chooseUnknownTensions();
  void layOut();
  void assembleOthers();
  Found factorise(double shift);
  bool solve(const Vector& b, Vector& x) const;
  Imbalance imbalance() const;
  double hang(const std::vector<double>& density);
  void guessTensions();
  void addTension(const Line& line, Triplets& entries) const;
  double largestEntry() const;
  Curvature lowest(double shift);
};

TensionForm::Parts::Parts(const ModelSystem& whole, const State& state)
    : system(whole),
      others(withoutSprings(whole)),
      still(*others, state.t),
      start(state),
      dimension(whole.dimension()),
      size(whole.size()) {
  const Model& model = whole.model();
  axes = dimension == 1   ? std::vector<int>{0}
         : dimension == 2 ? std::vector<int>{model.plane[0], model.plane[1]}
                          : std::vector<int>{0, 1, 2};
  zero.assign(static_cast<std::size_t>(size), 0.0);
  start.v = zero;
  for (std::size_t i = 0; i < model.springs.size(); ++i) {
    const ModelSpring& s = model.springs[i];
    Line line;
    line.spring = i;
    line.a = system.unknown(s.a, axes[0]);
    line.b = system.unknown(s.b, axes[0]);
    if (line.a < 0 && line.b < 0) continue;
    const auto compact = [&](int node) {
      const Vec3 full = system.position(start, node);
      Vec3 own = Vec3::Zero();
      for (std::size_t c = 0; c < axes.size(); ++c) own[static_cast<Eigen::Index>(c)] = full[axes[c]];
      return own;
    };
    line.fixedA = compact(s.a);
    line.fixedB = compact(s.b);
    line.k = s.k;
    line.L0 = s.L0;
    line.onlyPushes = s.unilateral;
    lines.push_back(line);
  }
}

void TensionForm::Parts::measure() {
  for (Line& line : lines) {
    Vec3 d = Vec3::Zero();
    for (Eigen::Index c = 0; c < dimension; ++c) {
      const double a = line.a < 0 ? line.fixedA[c] : hi[line.a + c];
      const double b = line.b < 0 ? line.fixedB[c] : hi[line.b + c];
      const double aRest = line.a < 0 ? 0.0 : lo[line.a + c];
      const double bRest = line.b < 0 ? 0.0 : lo[line.b + c];
      double rest = 0.0;
      const double first = difference(a, b, rest);
      d[c] = first + (rest + (aRest - bRest));
    }
    line.L = length<3>(d);
    line.n = line.L > 0.0 ? Vec3(d / line.L) : Vec3(Vec3::Zero());
  }
  ++work.forceEvaluations;
  otherForce.resize(size);
  const std::size_t count = static_cast<std::size_t>(size);
  still.potential()->conservativeForce(start.t, {hi.data(), count}, start.z, {otherForce.data(), count});
  F.assign(otherForce.data(), otherForce.data() + size);
  floor = otherForce.cwiseAbs();
  for (const Line& line : lines) {
    // One that just does not push would with the next bit.
    if (!line.acts() && !(line.onlyPushes && line.L <= (1.0 + 1e-12) * line.L0)) continue;
    const double T = line.tension();
    for (Eigen::Index c = 0; c < dimension; ++c) {
      const double pull = T * line.n[c];
      if (line.a >= 0) F[static_cast<std::size_t>(line.a + c)] -= pull;
      if (line.b >= 0) F[static_cast<std::size_t>(line.b + c)] += pull;
      // A spring that acts by its position knows its tension to what its length does.
      const double bits = std::abs(pull) + (line.mixed ? line.rho : line.k) * line.L * std::abs(line.n[c]);
      if (line.a >= 0) floor[line.a + c] += bits;
      if (line.b >= 0) floor[line.b + c] += bits;
    }
  }
  floor *= eps;
  if (otherFloor.size() == size) floor += otherFloor;
}

void TensionForm::Parts::chooseUnknownTensions() {
  double across = 0.0;  // largest T/L [N/m]
  double lengths = 0.0, stiffest = 0.0;
  for (const Line& line : lines) {
    stiffest = std::max(stiffest, line.k);
    if (line.L > 0.0) across = std::max(across, std::abs(line.tension()) / line.L);
    lengths += line.L;
  }
  typicalLength = lines.empty() || !(lengths > 0.0) ? 1.0 : lengths / static_cast<double>(lines.size());
  // Where the start says nothing yet: what one spring would be strained that carries all.
  across = std::max(across, load / typicalLength);
  const double rho = kept * across;
  const bool strained = across > leastStrain * stiffest;
  for (Line& line : lines) {
    const double T = line.tension();
    line.mixed = !line.onlyPushes && strained && line.k > stiff * rho && line.L > 0.0;
    line.rho = line.mixed ? rho : 0.0;
    line.S = line.mixed ? T - rho * (line.L - line.L0) : 0.0;
  }
  laidOut = false;
}

/// Nodes in an order of little fill, each followed by the tensions that first meet it there.
void TensionForm::Parts::layOut() {
  const Eigen::Index nodes = size / dimension;
  Triplets pairs;
  for (Eigen::Index j = 0; j < K.sparse.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(K.sparse, j); entry; ++entry) {
      if (entry.row() % dimension == 0 && j % dimension == 0) {
        pairs.emplace_back(static_cast<int>(entry.row() / dimension), static_cast<int>(j / dimension), 1.0);
      }
    }
  }
  Sparse graph(nodes, nodes);
  graph.setFromTriplets(pairs.begin(), pairs.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order(nodes);
  Eigen::AMDOrdering<int>()(graph, order);
  std::vector<std::vector<Line*>> touching(static_cast<std::size_t>(nodes));
  for (Line& line : lines) {
    line.row = -1;
    if (!line.mixed) continue;
    for (const int end : {line.a, line.b}) {
      if (end >= 0) touching[static_cast<std::size_t>(end / dimension)].push_back(&line);
    }
  }
  rowOf.assign(static_cast<std::size_t>(size), 0);
  int next = 0;
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const int node = order.indices()[i];
    const int first = dimension * node;
    for (int c = 0; c < dimension; ++c) rowOf[static_cast<std::size_t>(first) + static_cast<std::size_t>(c)] = next++;
    for (Line* line : touching[static_cast<std::size_t>(node)]) {
      if (line->row < 0) line->row = next++;
    }
  }
  lowRankRow.clear();
  for (Eigen::Index r = 0; r < K.lowRank.s.size(); ++r) lowRankRow.push_back(next++);
  rows = next;
  laidOut = true;
  analysed = false;
}

void TensionForm::Parts::assembleOthers() {
  const std::size_t count = static_cast<std::size_t>(size);
  still.linearisation()->assemble(0.0, 0.0, 1.0, start.t, {hi.data(), count}, zero, start.z, Form::Symmetric, K);
  ++work.jacobians;
  multiplyAbsolute(K, hi, otherFloor);
  otherFloor *= eps;
  if (!laidOut) layOut();
}

/// The matrix with `shift` on the diagonal of the positions, and its factors.
TensionForm::Parts::Found TensionForm::Parts::factorise(double shift) {
  Triplets entries;
  const auto row = [&](Eigen::Index unknown) { return rowOf[static_cast<std::size_t>(unknown)]; };
  for (Eigen::Index j = 0; j < size; ++j) {
    for (Sparse::InnerIterator entry(K.sparse, j); entry; ++entry) {
      entries.emplace_back(row(entry.row()), row(j), entry.value());
    }
    entries.emplace_back(row(j), row(j), shift);
  }
  int tensions = 0;
  for (const Line& line : lines) {
    if (line.k == 0.0 || (line.onlyPushes && !line.acts())) continue;
    const double along = line.stiffness();
    // At length 0 there is no direction; the matrix is that of a spring without rest length.
    const double across = line.L > 0.0 ? line.tension() / line.L : along;
    for (Eigen::Index p = 0; p < dimension; ++p) {
      for (Eigen::Index q = 0; q < dimension; ++q) {
        const double nn = line.n[p] * line.n[q];
        const double value = across * ((p == q ? 1.0 : 0.0) - nn) + along * nn;
        if (line.a >= 0) entries.emplace_back(row(line.a + p), row(line.a + q), value);
        if (line.b >= 0) entries.emplace_back(row(line.b + p), row(line.b + q), value);
        if (line.a >= 0 && line.b >= 0) {
          entries.emplace_back(row(line.a + p), row(line.b + q), -value);
          entries.emplace_back(row(line.b + p), row(line.a + q), -value);
        }
      }
    }
    if (!line.mixed) continue;
    ++tensions;
    addTension(line, entries);
  }
  for (std::size_t r = 0; r < lowRankRow.size(); ++r) {
    const double s = K.lowRank.s[static_cast<Eigen::Index>(r)];
    for (Eigen::Index i = 0; i < size; ++i) {
      const double u = K.lowRank.U(i, static_cast<Eigen::Index>(r));
      if (u == 0.0) continue;
      entries.emplace_back(row(i), lowRankRow[r], s * u);
      entries.emplace_back(lowRankRow[r], row(i), s * u);
    }
    entries.emplace_back(lowRankRow[r], lowRankRow[r], -s);
    ++tensions;
  }
  matrix.resize(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  ++work.factorisations;
  if (!analysed) ldlt.analyzePattern(matrix);
  analysed = true;
  ldlt.factorize(matrix);
  Found found;
  if (ldlt.info() != Eigen::Success) return found;
  const Vector& pivots = ldlt.vectorD();
  if (!pivots.allFinite()) return found;
  Vector sizes = Vector::Zero(rows);
  for (Eigen::Index j = 0; j < rows; ++j) {
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry) sizes[j] = std::max(sizes[j], std::abs(entry.value()));
  }
  found.usable = (pivots.array().abs() > 8.0 * eps * sizes.array()).all();
  found.negative = static_cast<int>((pivots.array() < 0.0).count()) - tensions;
  return found;
}

/// Solves with the last factors, refined; false where that is no solution.
bool TensionForm::Parts::solve(const Vector& b, Vector& x) const {
  x = ldlt.solve(b);
  if (!x.allFinite()) return false;
  const double norm = Eigen::Map<const Vector>(matrix.valuePtr(), matrix.nonZeros()).lpNorm<Eigen::Infinity>();
  double before = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 5; ++i) {
    const Vector left = b - matrix * x;
    const double error =
        left.lpNorm<Eigen::Infinity>() / (norm * x.lpNorm<Eigen::Infinity>() + b.lpNorm<Eigen::Infinity>() + 1e-300);
    if (error <= 2.0 * eps) return true;
    if (!(error < 0.5 * before)) return error < 1e-8;
    before = error;
    const Vector correction = ldlt.solve(left);
    if (!correction.allFinite()) return false;
    x += correction;
  }
  return before < 1e-8;
}

Imbalance TensionForm::Parts::imbalance() const {
  Imbalance result;
  result.atRoundOff = true;
  double sumForce = 0.0, sumLength = 0.0;
  int mixed = 0;
  const Eigen::Index nodes = size / dimension;
  for (Eigen::Index i = 0; i < nodes; ++i) {
    const Eigen::Map<const Vector> sum(F.data() + dimension * i, dimension);
    const double bits = floor.segment(dimension * i, dimension).norm();
    const double force = length<3>(Vec3(sum[0], dimension > 1 ? sum[1] : 0.0, dimension > 2 ? sum[2] : 0.0));
    if (!(force <= result.force)) {
      result.force = force;
      result.forceFloor = bits;
      result.worstUnknown = static_cast<int>(dimension * i);
    }
    if (!(force <= 64.0 * bits + 1e-290)) result.atRoundOff = false;
    sumForce += force * force;
  }
  for (const Line& line : lines) {
    if (!line.mixed) continue;
    ++mixed;
    const double error = std::abs(line.lengthError());
    result.length = std::max(result.length, error);
    if (!(error <= 16.0 * eps * (line.L + line.L0))) result.atRoundOff = false;
    sumLength += error * error;
  }
  // Where round-off is as large as the forces themselves, as beside a singular place, nothing balances.
  double forces = load, stiffest = 0.0;
  for (const Line& line : lines) {
    forces = std::max(forces, std::abs(line.tension()));
    stiffest = std::max(stiffest, line.k * line.L);
  }
  if (!(result.force <= trusted * forces + 64.0 * eps * stiffest)) result.atRoundOff = false;
  if (mixed == 0) result.length = -1.0;
  const double unit = load > 0.0 ? load / static_cast<double>(std::max<Eigen::Index>(nodes, 1)) : 1.0;
  result.merit = std::sqrt(sumForce / static_cast<double>(std::max<Eigen::Index>(nodes, 1))) / unit +
                 (mixed > 0 ? std::sqrt(sumLength / mixed) / typicalLength : 0.0);
  return result;
}

double TensionForm::Parts::largestEntry() const {
  double largest = 0.0;
  for (Eigen::Index j = 0; j < K.sparse.outerSize(); ++j) {
    for (Sparse::InnerIterator entry(K.sparse, j); entry; ++entry) largest = std::max(largest, std::abs(entry.value()));
  }
  for (Eigen::Index r = 0; r < K.lowRank.s.size(); ++r) {
    largest = std::max(largest, std::abs(K.lowRank.s[r]) * K.lowRank.U.col(r).cwiseAbs2().maxCoeff());
  }
  for (const Line& line : lines) {
    if (line.k == 0.0) continue;
    largest = std::max(largest, line.stiffness());
    if (line.L > 0.0) largest = std::max(largest, std::abs(line.tension()) / line.L);
  }
  return largest;
}

/// Inverse iteration of a few vectors at once with the last factors, those of K + shift I: neighbours of the smallest
/// eigenvalue do not slow it down.
Curvature TensionForm::Parts::lowest(double shift) {
  Curvature result;
  const Eigen::Index width = std::min<Eigen::Index>(6, size);
  MatX Y(size, width), X(rows, width);
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index c = 0; c < width; ++c) Y(i, c) = std::sin(1.0 + 1.7 * static_cast<double>((i + 1) * (c + 1)));
  }
  orthonormalise(Y);
  Vector b = Vector::Zero(rows), x(rows), y;
  const double scale = largestEntry();
  double value = 0.0;
  for (int i = 0; i < 100; ++i) {
    MatX Z(size, width);
    for (Eigen::Index c = 0; c < width; ++c) {
      for (Eigen::Index j = 0; j < size; ++j) b[rowOf[static_cast<std::size_t>(j)]] = Y(j, c);
      ++work.solves;
      if (!solve(b, x)) return result;
      X.col(c) = x;
      for (Eigen::Index j = 0; j < size; ++j) Z(j, c) = x[rowOf[static_cast<std::size_t>(j)]];
    }
    const MatX B = Y.transpose() * Z;
    const SymmetricEigenpairs pairs = symmetricEigenpairs(0.5 * (B + B.transpose()));
    // Of K + shift I, which is positive but for round-off: the smallest eigenvalue has the largest inverse.
    Eigen::Index best = 0;
    pairs.values.cwiseAbs().maxCoeff(&best);
    const double now = 1.0 / pairs.values[best] - shift;
    y = Z * pairs.vectors.col(best);
    x = X * pairs.vectors.col(best) / y.norm();
    y.normalize();
    // Of what is 0 no digit ever settles.
    const bool settled = i > 2 && std::abs(now - value) <= 1e-11 * std::abs(now + shift) + 4.0 * eps * scale;
    value = now;
    if (settled) break;
    Y = Z * pairs.vectors;
    orthonormalise(Y);
  }
  // What the last bits of the entries do to y^T (K y): |A| |y|, and the tensions' rows with their part of x.
  Vector sizes = Vector::Zero(rows);
  for (Eigen::Index j = 0; j < rows; ++j) {
    for (Sparse::InnerIterator entry(matrix, j); entry; ++entry) {
      sizes[entry.row()] += std::abs(entry.value()) * std::abs(x[j]);
    }
  }
  double sum = 0.0;
  for (Eigen::Index j = 0; j < size; ++j) {
    const double own = sizes[rowOf[static_cast<std::size_t>(j)]];
    sum += own * own;
  }
  result.known = std::isfinite(value);
  result.smallest = value;
  result.roundOff = 256.0 * eps * std::sqrt(sum);
  result.along.assign(y.data(), y.data() + size);
  return result;
}

/// Tensions that leave the least sum of forces (least squares), where they do better than those that the lengths say:
/// a spring that is drawn at its rest length says nothing, and a stiff one nothing but round-off.
void TensionForm::Parts::guessTensions() {
  const bool any = std::ranges::any_of(lines, [](const Line& line) { return line.mixed; });
  if (!any || !(load > 0.0)) return;
  const double before = imbalance().merit;
  std::vector<double> said;
  double rho = 0.0;
  for (Line& line : lines) {
    said.push_back(line.S);
    if (!line.mixed) continue;
    line.S = -line.rho * (line.L - line.L0);
    rho = line.rho;
  }
  measure();
  assembleOthers();
  // The matrix of the method with rho I in the place of the stiffness.
  Triplets entries;
  Vector b = Vector::Zero(rows), x;
  for (Eigen::Index i = 0; i < size; ++i) {
    const int row = rowOf[static_cast<std::size_t>(i)];
    entries.emplace_back(row, row, rho);
    b[row] = F[static_cast<std::size_t>(i)];
  }
  for (const Line& line : lines) {
    if (line.mixed) addTension(line, entries);
  }
  for (const int row : lowRankRow) entries.emplace_back(row, row, -1.0);
  matrix.resize(rows, rows);
  matrix.setFromTriplets(entries.begin(), entries.end());
  ++work.factorisations;
  ldlt.compute(matrix);
  analysed = false;
  ++work.solves;
  const bool solved = ldlt.info() == Eigen::Success && solve(b, x);
  for (std::size_t j = 0; solved && j < lines.size(); ++j) {
    if (lines[j].mixed) lines[j].S += lines[j].rho * x[lines[j].row];
  }
  measure();
  if (solved && imbalance().merit < before) return;
  for (std::size_t j = 0; j < lines.size(); ++j) lines[j].S = said[j];
  measure();
}

/// The rows and columns of an unknown tension: of S / rho, so that all entries are of one size.
void TensionForm::Parts::addTension(const Line& line, Triplets& entries) const {
  for (const auto& [end, sign] : {std::pair(line.a, line.rho), std::pair(line.b, -line.rho)}) {
    for (Eigen::Index c = 0; end >= 0 && c < dimension; ++c) {
      const int row = rowOf[static_cast<std::size_t>(end + c)];
      entries.emplace_back(row, line.row, sign * line.n[c]);
      entries.emplace_back(line.row, row, sign * line.n[c]);
    }
  }
  entries.emplace_back(line.row, line.row, -line.rho * (line.rho / (line.k - line.rho)));
}

/// Puts the nodes where force densities c times those given hold the loads, c such that the sum of L - L0 - T/k is 0;
/// returns c [N], or 0 where that system is singular.
double TensionForm::Parts::hang(const std::vector<double>& density) {
  // Positions that the fixed nodes give, and those that the loads add, for c = 1.
  Triplets entries;
  Vector pull = Vector::Zero(size);
  for (std::size_t j = 0; j < lines.size(); ++j) {
    const Line& line = lines[j];
    const double q = density[j];
    for (int i = 0; i < dimension; ++i) {
      if (line.a >= 0) entries.emplace_back(line.a + i, line.a + i, q);
      if (line.b >= 0) entries.emplace_back(line.b + i, line.b + i, q);
      if (line.a >= 0 && line.b >= 0) {
        entries.emplace_back(line.a + i, line.b + i, -q);
        entries.emplace_back(line.b + i, line.a + i, -q);
      } else if (line.a >= 0) {
        pull[line.a + i] += q * line.fixedB[i];
      } else {
        pull[line.b + i] += q * line.fixedA[i];
      }
    }
  }
  Sparse D(size, size);
  D.setFromTriplets(entries.begin(), entries.end());
  ++work.factorisations;
  const Eigen::SimplicialLDLT<Sparse> solver(D);
  if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 1e-12 * solver.vectorD().maxCoeff())) {
    return 0.0;
  }
  const Vector held = solver.solve(pull), sag = solver.solve(otherForce);
  work.solves += 2;
  if (!held.allFinite() || !sag.allFinite()) return 0.0;
  lo.setZero();
  const auto excess = [&](double c) {
    hi = held + sag / c;
    double sum = 0.0;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      Line& line = lines[j];
      line.mixed = false;
      Vec3 d = Vec3::Zero();
      for (int i = 0; i < dimension; ++i) {
        d[i] = (line.a < 0 ? line.fixedA[i] : hi[line.a + i]) - (line.b < 0 ? line.fixedB[i] : hi[line.b + i]);
      }
      line.L = d.norm();
      sum += line.L * (1.0 - c * density[j] / line.k) - line.L0;
    }
    return sum;
  };
  // Bisection of log c: more force makes them shorter and stretches them more.
  double low = 1e-12 * load, high = load;
  while (excess(high) > 0.0 && high < 1e30 * load) high *= 16.0;
  for (int i = 0; i < 80; ++i) {
    const double middle = std::sqrt(low * high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  excess(high);
  return high;
}

TensionForm::TensionForm(const ModelSystem& system, const State& start)
    : parts_(std::make_unique<Parts>(system, start)) {
  Parts& p = *parts_;
  p.lo = Vector::Zero(p.size);
  p.hi = Eigen::Map<const Vector>(start.x.data(), p.size);
  p.measure();
  for (Eigen::Index i = 0; i + p.dimension <= p.size; i += p.dimension) {
    p.load += p.otherForce.segment(i, p.dimension).norm();
  }
  place(start.x);
}

TensionForm::~TensionForm() = default;

void TensionForm::place(In x) {
  Parts& p = *parts_;
  p.hi = Eigen::Map<const Vector>(x.data(), p.size);
  p.lo = Vector::Zero(p.size);
  for (Line& line : p.lines) line.mixed = false;
  p.measure();
  p.chooseUnknownTensions();
  p.measure();
  p.guessTensions();
}

void TensionForm::place(In x, const std::vector<double>& tensions) {
  place(x);
  Parts& p = *parts_;
  for (Line& line : p.lines) {
    const double T = tensions[line.spring];
    if (line.mixed && std::isfinite(T)) line.S = T - line.rho * (line.L - line.L0);
  }
  p.measure();
}

bool TensionForm::placeByForceDensity() {
  Parts& p = *parts_;
  if (p.lines.empty() || !(p.load > 0.0)) return false;
  std::vector<double> density;
  for (const Line& line : p.lines) {
    if (!(line.L0 > 0.0) || line.k == 0.0) return false;
    density.push_back(1.0 / line.L0);
  }
  double c = 0.0;
  for (int i = 0; i < densityPasses; ++i) {
    c = p.hang(density);
    if (!(c > 0.0)) return false;
    if (i + 1 == densityPasses) break;
    // A spring that came out too long needs more force for its length.
    for (std::size_t j = 0; j < density.size(); ++j) {
      const Line& line = p.lines[j];
      density[j] *= line.L / (line.L0 + c * density[j] * line.L / line.k);
    }
  }
  double across = 0.0;
  for (const double q : density) across = std::max(across, c * q);
  for (std::size_t j = 0; j < density.size(); ++j) {
    Line& line = p.lines[j];
    line.mixed = true;
    line.rho = std::min(kept * across, 0.5 * line.k);
    line.S = c * density[j] * line.L - line.rho * (line.L - line.L0);
  }
  p.laidOut = false;
  p.typicalLength = 0.0;
  for (const Line& line : p.lines) p.typicalLength += line.L0 / static_cast<double>(p.lines.size());
  p.measure();
  return true;
}

Imbalance TensionForm::solve(int mostFactorisations, bool pulling) {
  Parts& p = *parts_;
  Imbalance now = p.imbalance();
  const long long last = p.work.factorisations + mostFactorisations;
  double shift = 0.0;
  while (p.work.factorisations < last) {
    ++p.work.newtonIterations;
    p.assembleOthers();
    p.measure();
    now = p.imbalance();
    if (now.merit == 0.0) break;
    Parts::Found found = p.factorise(shift);
    if (!found.usable && p.work.factorisations < last) {
      // Free to move without a force: a small shift leaves the rest of the step as it is.
      shift = slight * p.largestEntry();
      found = p.factorise(shift);
    }
    if (!found.usable) break;
    Vector b = Vector::Zero(p.rows), x;
    for (Eigen::Index i = 0; i < p.size; ++i) {
      b[p.rowOf[static_cast<std::size_t>(i)]] = p.F[static_cast<std::size_t>(i)];
    }
    for (const Line& line : p.lines) {
      if (line.mixed) b[line.row] = -line.rho * line.lengthError();
    }
    ++p.work.solves;
    if (!p.solve(b, x)) break;
    double part = 1.0;
    if (pulling) {
      for (const Line& line : p.lines) {
        if (!line.mixed) continue;
        const double change = line.rho * x[line.row], T = line.tension();
        if (change < 0.0 && T > 0.0) part = std::min(part, 0.9 * T / -change);
      }
    }
    const Vector hi = p.hi, lo = p.lo;
    std::vector<double> S;
    for (const Line& line : p.lines) S.push_back(line.S);
    Imbalance next;
    bool better = false;
    for (int halving = 0; halving < 12 && !better; ++halving, part *= 0.5) {
      for (Eigen::Index i = 0; i < p.size; ++i) {
        const double by = lo[i] + part * x[p.rowOf[static_cast<std::size_t>(i)]];
        double rest = 0.0;
        p.hi[i] = difference(hi[i], -by, rest);
        p.lo[i] = rest;
      }
      for (std::size_t j = 0; j < S.size(); ++j) {
        if (p.lines[j].mixed) p.lines[j].S = S[j] + part * p.lines[j].rho * x[p.lines[j].row];
      }
      p.measure();
      next = p.imbalance();
      better = next.merit < now.merit;
      if (now.atRoundOff) break;
    }
    if (!better) {
      p.hi = hi;
      p.lo = lo;
      for (std::size_t j = 0; j < S.size(); ++j) p.lines[j].S = S[j];
      p.measure();
      if (now.atRoundOff || shift > 0.0) break;
      // Along what costs nothing the step is round-off over round-off: held back, the rest of it helps.
      shift = slight * p.largestEntry();
      continue;
    }
    now = next;
  }
  return p.imbalance();
}

Imbalance TensionForm::imbalance() const { return parts_->imbalance(); }

Curvature TensionForm::curvature() {
  Parts& p = *parts_;
  p.assembleOthers();
  p.measure();
  const double scale = p.largestEntry();
  if (!(scale > 0.0)) {
    Curvature none;
    none.known = true;
    return none;
  }
  const Parts::Found plain = p.factorise(0.0);
  if (plain.usable && plain.negative == 0) {
    const Curvature direct = p.lowest(0.0);
    if (direct.known) return direct;
  }
  // Something is negative, or nothing holds it: the least shift that makes all of it positive, within a tenth.
  double low = 0.0, high = 1e-10 * scale;
  Parts::Found found = p.factorise(high);
  for (int i = 0; i < 14 && !(found.usable && found.negative <= 0); ++i) {
    low = high;
    high *= 8.0;
    found = p.factorise(high);
  }
  if (!found.usable || found.negative > 0) return {};
  for (int i = 0; i < 5 && low > 0.0; ++i) {
    const double middle = std::sqrt(low * high);
    found = p.factorise(middle);
    (found.usable && found.negative <= 0 ? high : low) = middle;
  }
  if (!p.factorise(high).usable) return {};
  Curvature result = p.lowest(high);
  if (result.smallest < -result.roundOff) {
    const Parts::Found beyond = p.factorise(result.roundOff);
    result.negative = beyond.usable ? std::max(1, beyond.negative) : 1;
  }
  return result;
}

std::vector<double> TensionForm::positions() const { return {parts_->hi.data(), parts_->hi.data() + parts_->size}; }

std::vector<double> TensionForm::tensions() const {
  const Parts& p = *parts_;
  const Model& model = p.system.model();
  std::vector<double> result;
  for (const ModelSpring& s : model.springs) {
    const double L = (p.system.position(p.start, s.a) - p.system.position(p.start, s.b)).norm();
    result.push_back(s.unilateral && L > s.L0 ? 0.0 : s.k * (L - s.L0));  // between fixed nodes
  }
  for (const Line& line : p.lines) {
    const double T = line.tension();
    const bool directed = line.L > 0.0 || line.L0 == 0.0 || line.k == 0.0;
    const bool isRoundOff = std::abs(T) <= 4.0 * eps * (line.mixed ? line.rho : line.k) * line.L;
    result[line.spring] = isRoundOff ? 0.0 : directed ? T : std::numeric_limits<double>::quiet_NaN();
  }
  return result;
}

const std::vector<double>& TensionForm::forces() const { return parts_->F; }

int TensionForm::unknownTensions() const {
  return static_cast<int>(std::ranges::count_if(parts_->lines, [](const Line& line) { return line.mixed; }));
}

double TensionForm::load() const { return parts_->load; }

const Work& TensionForm::work() const { return parts_->work; }

}  // namespace muelle::engine
