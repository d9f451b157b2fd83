#include "engine/model/parts.h"

#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "engine/model/validate.h"

#include <fmt/format.h>
#include <algorithm>
#include <stdexcept>

namespace muelle::engine {

namespace {

/// Calls use(name of the kind, list) for each list of elements that have a part.
template <class AnyModel, class Use>
void forEachKind(AnyModel& model, const Use& use) {
  use("spring", model.springs);
  forEachElementKind(model, [&]<class List>(List& elements) { use(ElementOf<List>::kind, elements); });
  use("property", model.properties);
  use("force", model.externalForces);
}

std::string partNameOf(const Model& model, int part, const char* kind) {
  return part == partOfItsKind ? kind : model.parts[static_cast<std::size_t>(part)];
}

std::string partNameOf(const Obstacle& obstacle) { return "obstacle " + obstacle.name; }

/// What an element adds to the count of its part.
class ElementCount {
 public:
  explicit ElementCount(const Model& model) : model_(model) {}

  template <class Element>
  long long of(const Element& e) const {
    return anyFree(model_, e.nodes) ? 1 : 0;
  }
  long long of(const ModelSpring& e) const { return !e.rod && anyFree(model_, std::array{e.a, e.b}) ? 1 : 0; }
  long long of(const ModelProperty& e) const { return std::ssize(e.nodes); }
  long long of(const ModelExternalForce& e) const {
    return std::ranges::count_if(e.nodes, [this](int i) { return isFreeNode(i); });
  }

 private:
  bool isFreeNode(int i) const { return isFree(model_.nodes[static_cast<std::size_t>(i)]); }

  const Model& model_;
};

void addTo(std::vector<ModelPart>& parts, const std::string& name, long long elements) {
  const auto found = std::ranges::find(parts, name, &ModelPart::name);
  if (found == parts.end()) {
    parts.push_back({name, elements});
  } else {
    found->elements += elements;
  }
}

}  // namespace

std::vector<ModelPart> partsOf(const Model& model) {
  std::vector<ModelPart> parts;
  const ElementCount count(model);
  forEachKind(model, [&](const char* kind, const auto& elements) {
    // Neighbours in a list mostly share their part: a name is looked up where it changes alone.
    for (std::size_t i = 0, next = 0; i < elements.size(); i = next) {
      long long sum = 0;
      for (; next < elements.size() && elements[next].part == elements[i].part; ++next) sum += count.of(elements[next]);
      addTo(parts, partNameOf(model, elements[i].part, kind), sum);
    }
  });
  const long long free = std::ranges::count_if(model.nodes, isFree);
  for (const Obstacle& obstacle : model.obstacles) addTo(parts, partNameOf(obstacle), free);
  if (!model.gravity.isZero(0.0)) addTo(parts, "gravity", free);
  const long long dragged =
      std::ranges::count_if(model.nodes, [](const ModelNode& node) { return isFree(node) && node.drag > 0.0; });
  if (dragged > 0) addTo(parts, "drag", dragged);
  return parts;
}

Model withoutParts(const Model& model, const std::vector<std::string>& names) {
  validate(model);
  std::vector<std::string> known;
  for (const ModelPart& part : partsOf(model)) known.push_back(part.name);
  for (const std::string& name : names) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw std::invalid_argument(
        fmt::format("there is no part '{}'{}", printableLine(name),
                    known.empty() ? std::string("; the model has no forces") : printableLine(suggestion(name, known))));
  }
  const auto isOut = [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); };
  Model rest = model;
  forEachKind(rest, [&](const char* kind, auto& elements) {
    std::vector<char> out(rest.parts.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = isOut(rest.parts[i]) ? 1 : 0;
    const bool kindIsOut = isOut(kind);
    std::erase_if(elements, [&](const auto& element) {
      return element.part == partOfItsKind ? kindIsOut : out[static_cast<std::size_t>(element.part)] != 0;
    });
  });
  std::erase_if(rest.obstacles, [&](const Obstacle& obstacle) { return isOut(partNameOf(obstacle)); });
  if (isOut("gravity")) rest.gravity.setZero();
  if (isOut("drag")) {
    for (ModelNode& node : rest.nodes) node.drag = 0.0;
  }
  return rest;
}

int partNamed(Model& model, const std::string& name) {
  const auto found = std::ranges::find(model.parts, name);
  if (found != model.parts.end()) return static_cast<int>(found - model.parts.begin());
  model.parts.push_back(name);
  return static_cast<int>(model.parts.size()) - 1;
}

}  // namespace muelle::engine
