#include "engine/contact/contact.h"
#include "engine/forces/external_force.h"
#include "engine/forces/gravity.h"
#include "engine/forces/property.h"
#include "engine/forces/spring.h"
#include "engine/kernels/grid_numbering.h"
#include "engine/model/axes.h"
#include "engine/model/builder.h"
#include "engine/model/damping.h"
#include "engine/model/few_springs.h"
#include "engine/model/numbering.h"
#include "engine/model/parts.h"
#include "engine/model/validate.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace muelle::engine {

namespace {

/// Pairs of free nodes that share an element, in the user's numbers.
std::vector<std::pair<int, int>> couplings(const Model& model) {
  std::vector<std::pair<int, int>> edges;
  const auto join = [&](const auto& nodes) {
    for (auto a = nodes.begin(); a != nodes.end(); ++a) {
      for (auto b = nodes.begin(); b != a; ++b) {
        if (isFree(model.nodes[static_cast<std::size_t>(*a)]) && isFree(model.nodes[static_cast<std::size_t>(*b)])) {
          edges.emplace_back(*a, *b);
        }
      }
    }
  };
  for (const ModelSpring& s : model.springs) join(std::array{s.a, s.b});
  forEachElementKind(model, [&](const auto& elements) {
    for (const auto& element : elements) join(element.nodes);
  });
  return edges;
}

/// Whether the spring's force is that of its distance, always: such springs alone make a grid. (Without a rest length
/// nothing happens at zero length.)
bool isPlain(const Model& model, const ModelSpring& s) {
  const bool crosses = s.L0 > 0.0 && (model.dimension == 1 || model.springsCross);
  return !s.rod && !s.isSigned && !s.unilateral && !crosses;
}

/// The grid that the springs are on; none where they are few, or not all plain.
kernels::GridNumbering gridOf(const Model& model, const std::vector<int>& axes) {
  constexpr std::size_t few = 64;  // springs, below which a grid gains nothing
  if (!model.renumber || model.springs.size() < few) return {};
  std::vector<kernels::SpringData> springs;
  for (const ModelSpring& s : model.springs) {
    if (!isPlain(model, s)) return {};
    springs.push_back({s.a, s.b, s.k, s.L0, s.dRelative, projectedDamping(model, s)});
  }
  std::vector<double> x;
  for (const ModelNode& node : model.nodes) {
    for (const int axis : axes) x.push_back(node.x[axis]);
  }
  return kernels::findGrid(static_cast<int>(axes.size()), x, springs);
}

/// By the places of a grid, or with the free nodes first in the order of Cuthill and McKee.
Numbering number(const Model& model, const kernels::GridNumbering& grid) {
  const int count = static_cast<int>(model.nodes.size());
  const auto free = [&](int i) { return isFree(model.nodes[static_cast<std::size_t>(i)]); };
  Numbering numbering;
  numbering.axes = axesOf(model);
  const int dimension = static_cast<int>(numbering.axes.size());
  if (grid.order != kernels::GridOrder::None) {
    numbering.layout = Layout::planar(dimension, static_cast<int>(kernels::planeFor(grid.places)));
    numbering.built = grid.place;
    numbering.user.assign(grid.places, -1);
  } else {
    std::vector<int> order(model.nodes.size());
    std::iota(order.begin(), order.end(), 0);
    if (model.renumber) order = reverseCuthillMcKee(count, couplings(model));
    std::stable_partition(order.begin(), order.end(), free);
    numbering.layout = Layout::padded(dimension, count);
    numbering.built.resize(order.size());
    for (int i = 0; i < count; ++i) numbering.built[static_cast<std::size_t>(order[static_cast<std::size_t>(i)])] = i;
    numbering.user.assign(order.size(), -1);
  }
  for (int i = 0; i < count; ++i) {
    numbering.user[static_cast<std::size_t>(numbering.built[static_cast<std::size_t>(i)])] = i;
  }
  numbering.rank.assign(numbering.user.size(), -1);
  for (std::size_t place = 0; place < numbering.user.size(); ++place) {
    if (numbering.user[place] < 0 || !free(numbering.user[place])) continue;
    numbering.rank[place] = static_cast<int>(numbering.freeNodes.size());
    numbering.freeNodes.push_back(static_cast<int>(place));
  }
  return numbering;
}

/// m g [N] of each lane.
std::vector<double> weights(const Builder& builder) {
  const Vec3& g = builder.model.gravity;
  return builder.lanes([&](const ModelNode& node, int axis) { return node.m * g[axis]; });
}

void addGravity(Builder& builder) {
  if (builder.model.gravity.isZero(0.0)) return;
  builder.batches.push_back(std::make_unique<Gravity>(weights(builder)));
}

/// The sign of xa - xb at the start.
double sideOf(const Model& model, const ModelSpring& spring) {
  const auto at = [&model](int node) { return model.nodes[static_cast<std::size_t>(node)].x[0]; };
  return at(spring.a) < at(spring.b) ? -1.0 : 1.0;
}

SpringKind kindOf(const Model& model, const ModelSpring& spring) {
  if (spring.unilateral) return SpringKind::Unilateral;
  if (spring.isSigned) return SpringKind::Signed;
  return isPlain(model, spring) ? SpringKind::Plain : SpringKind::Crossing;
}

/// A batch for each kind and damping form that there is.
template <int D>
void addSprings(Builder& builder) {
  std::map<std::pair<SpringKind, kernels::Damping>, std::vector<SpringElement>> all;
  for (std::size_t i = 0; i < builder.model.springs.size(); ++i) {
    const ModelSpring& s = builder.model.springs[i];
    if (s.rod || !anyFree(builder.model, std::array{s.a, s.b})) continue;
    const double dProjected = projectedDamping(builder.model, s);
    const kernels::Damping form = kernels::dampingOf({s.a, s.b, s.k, s.L0, s.dRelative, dProjected}, D);
    all[{kindOf(builder.model, s), form}].push_back({builder.built(s.a), builder.built(s.b), s.k, s.L0, s.dRelative,
                                                     dProjected, static_cast<int>(i),
                                                     s.isSigned ? sideOf(builder.model, s) : 0.0});
  }
  for (auto& [kindAndForm, springs] : all) {
    // In the order of memory; no two springs share both ends, so the order is the same on every machine.
    std::sort(springs.begin(), springs.end(), [](const SpringElement& p, const SpringElement& q) {
      return std::pair(std::min(p.a, p.b), std::max(p.a, p.b)) < std::pair(std::min(q.a, q.b), std::max(q.a, q.b));
    });
    builder.batches.push_back(std::make_unique<Spring<D>>(springs, kindAndForm.first, builder.numbering.layout));
  }
}

template <int D>
Eigen::Matrix<double, D, 1> inScene(const Vec3& full, const std::vector<int>& axes) {
  Eigen::Matrix<double, D, 1> own;
  for (int c = 0; c < D; ++c) own[c] = full[axes[static_cast<std::size_t>(c)]];
  return own;
}

void addProperties(Builder& builder) {
  const std::vector<int>& axes = builder.numbering.axes;
  const int dimension = builder.dimension();
  for (std::size_t p = 0; p < builder.model.properties.size(); ++p) {
    const ModelProperty& property = builder.model.properties[p];
    std::vector<Property::Entry> entries, merged;
    for (std::size_t i = 0; i < property.nodes.size(); ++i) {
      const int node = builder.built(property.nodes[i]), rank = builder.numbering.rank[static_cast<std::size_t>(node)];
      for (int c = 0; c < dimension; ++c) {
        const double weight = property.weights[i][axes[static_cast<std::size_t>(c)]];
        const int unknown = rank < 0 ? -1 : dimension * rank + c;
        if (weight != 0.0) entries.push_back({builder.numbering.layout.lane(node, c), unknown, weight});
      }
    }
    std::ranges::stable_sort(entries, {}, &Property::Entry::lane);
    for (const Property::Entry& entry : entries) {
      if (!merged.empty() && merged.back().lane == entry.lane) {
        merged.back().weight += entry.weight;
      } else {
        merged.push_back(entry);
      }
    }
    builder.batches.push_back(
        std::make_unique<Property>(std::move(merged), property.k, property.p0, static_cast<int>(p)));
  }
}

template <int D>
void addExternalForces(Builder& builder) {
  std::vector<typename ExternalForce<D>::Item> items;
  for (const ModelExternalForce& external : builder.model.externalForces) {
    std::vector<int> nodes;
    for (const int user : external.nodes) {
      if (builder.isFreeNode(user)) nodes.push_back(builder.built(user));
    }
    const auto force = [full = external.force, axes = builder.numbering.axes](double t, int segment) {
      return inScene<D>(full(t, segment), axes);
    };
    items.push_back({std::move(nodes), force, external.times});
  }
  if (!items.empty()) builder.batches.push_back(std::make_unique<ExternalForce<D>>(std::move(items)));
}

template <int D>
void addObstacles(Builder& builder) {
  const std::vector<int>& axes = builder.numbering.axes;
  ContactNodes nodes;
  nodes.built = builder.numbering.freeNodes;
  for (const int i : nodes.built) {
    nodes.user.push_back(builder.numbering.user[static_cast<std::size_t>(i)]);
    nodes.mass.push_back(builder.node(i).m);
  }
  for (const Obstacle& obstacle : builder.model.obstacles) {
    const ContactMaterial& material = obstacle.material;
    const double kTangential = material.kTangential > 0.0 ? material.kTangential : material.k;
    ObstacleData<D> data{obstacle.name,
                         inScene<D>(obstacle.centre, axes),
                         inScene<D>(obstacle.velocity, axes),
                         obstacle.stopTime,
                         material.k,
                         material.d,
                         {material.mu, kTangential, material.dTangential}};
    const auto add = [&]<class Shape>(Shape shape) {
      builder.batches.push_back(std::make_unique<Contact<D, Shape>>(std::move(data), std::move(shape), nodes));
    };
    switch (obstacle.kind) {
      case Obstacle::Kind::Plane:
        add(Plane<D>{inScene<D>(obstacle.normal, axes).normalized()});
        break;
      case Obstacle::Kind::Sphere:
        add(Sphere<D>{obstacle.radius});
        break;
      case Obstacle::Kind::Box:
        add(Box<D>{inScene<D>(obstacle.halfSize, axes)});
        break;
    }
  }
}

std::unique_ptr<NodeDrag> makeDrag(const Builder& builder) {
  std::vector<double> coefficients = builder.lanes([](const ModelNode& node, int) { return node.drag; });
  if (std::ranges::all_of(coefficients, [](double d) { return d == 0.0; })) return nullptr;
  auto drag = std::make_unique<NodeDrag>(std::move(coefficients), builder.numbering.freeNodes, builder.dimension());
  drag->setLayout(builder.numbering.layout);
  return drag;
}

/// The springs of a grid with gravity and drag; none where there is no grid.
std::optional<GridForce> makeGridForce(const Builder& builder, kernels::GridNumbering grid) {
  if (grid.order == kernels::GridOrder::None) return std::nullopt;
  const Layout& layout = builder.numbering.layout;
  GridNodes nodes;
  nodes.plane = static_cast<std::size_t>(layout.component);
  for (int c = 0; c < builder.dimension(); ++c) {
    nodes.gravity[c] = builder.model.gravity[builder.numbering.axes[static_cast<std::size_t>(c)]];
  }
  const bool anyDrag = std::ranges::any_of(builder.model.nodes, [](const ModelNode& node) { return node.drag > 0.0; });
  if (anyDrag) {
    nodes.drag.assign(nodes.plane, 0.0);
    for (const int i : builder.numbering.freeNodes) nodes.drag[static_cast<std::size_t>(i)] = builder.node(i).drag;
  }
  return GridForce(kernels::GridSprings(builder.dimension(), grid.places, std::move(grid.search.runs),
                                        std::move(grid.search.loose), 0, builder.model.precision),
                   std::move(nodes));
}

/// All the forces together, where they are a few springs of one damping form, and gravity.
template <int D>
std::optional<FewSprings> makeFewSprings(const Builder& builder) {
  const std::size_t springBatches = builder.batches.size() - (builder.model.gravity.isZero(0.0) ? 0 : 1);
  if (springBatches != 1) return std::nullopt;
  const auto* springs = dynamic_cast<const Spring<D>*>(builder.batches.back().get());
  if (springs == nullptr) return std::nullopt;
  const bool crossing = springs->lineRun() != nullptr;
  const kernels::SpringRun* run = crossing ? springs->lineRun() : springs->plainRun();
  if (run == nullptr || run->size() > FewSprings::most) return std::nullopt;
  return FewSprings(D, *run, crossing, weights(builder));
}

template <int D>
std::unique_ptr<ModelSystem> buildIn(const Model& model) {
  kernels::GridNumbering grid = gridOf(model, axesOf(model));
  Numbering numbering = number(model, grid);
  Builder builder{model, numbering};
  addGravity(builder);
  addSprings<D>(builder);
  const std::size_t onGrid = builder.batches.size();
  std::optional<GridForce> gridForce = makeGridForce(builder, std::move(grid));
  forEachElementKind(model, [&]<class List>(const List& elements) { ElementOf<List>::addTo(builder, elements); });
  addProperties(builder);
  addExternalForces<D>(builder);
  addObstacles<D>(builder);
  std::unique_ptr<NodeDrag> drag = makeDrag(builder);
  std::optional<FewSprings> few = makeFewSprings<D>(builder);
  auto batches = std::move(builder.batches);
  for (const auto& batch : batches) batch->setLayout(numbering.layout);
  return std::make_unique<MassSpringSystem>(model, std::move(numbering), std::move(batches), std::move(drag),
                                            std::move(gridForce), onGrid, std::move(few));
}

}  // namespace

std::unique_ptr<ModelSystem> build(const Model& model, const std::vector<std::string>& without) {
  if (!without.empty()) return build(withoutParts(model, without));
  validate(model);
  switch (model.dimension) {
    case 1:
      return buildIn<1>(model);
    case 2:
      return buildIn<2>(model);
    default:
      return buildIn<3>(model);
  }
}

}  // namespace muelle::engine
