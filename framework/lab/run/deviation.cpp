#include "lab/run/deviation.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace muelle::lab {

using namespace engine;

namespace {

constexpr std::size_t mostComparedRows = 2000;

/// The scene's outputs that are measured along the run, as the trajectory's tracks name them.
std::vector<const SceneOutput*> measuredOutputs(const Scene& scene) {
  std::vector<const SceneOutput*> outputs;
  for (const SceneOutput& output : scene.outputs) {
    if (output.kind != SceneOutput::Kind::Path) outputs.push_back(&output);
  }
  return outputs;
}

/// The values of output i: the tracks begin with the energies, the outputs end them.
const std::vector<double>& valuesOf(const Trajectory& trajectory, std::size_t outputs, std::size_t i) {
  return trajectory.tracks[trajectory.tracks.size() - outputs + i].values;
}

/// V along the output's axis, 0 where the scene has none such.
double driftAlong(const Model& model, const MotionFrame& frame, const SceneOutput& output) {
  const std::array<int, 3> axes =
      model.dimension == 2 ? std::array<int, 3>{model.plane[0], model.plane[1], -1} : std::array<int, 3>{0, 1, 2};
  for (int c = 0; c < model.dimension; ++c) {
    if (axes[static_cast<std::size_t>(c)] == output.axis) return frame.drift()[static_cast<std::size_t>(c)];
  }
  return 0.0;
}

/// How far an output moves from where it starts, beyond what the flight of all does to it.
double outputMotion(const SceneOutput& output, const std::vector<double>& t, const std::vector<double>& values,
                    double drift) {
  double largest = 0.0;
  for (std::size_t row = 0; row < values.size(); ++row) {
    double moved = values[row] - values[0];
    if (output.kind == SceneOutput::Kind::Velocity) {
      moved = values[row] - drift;
    } else if (output.kind != SceneOutput::Kind::Distance) {
      moved -= drift * (t[row] - t[0]);
    }
    largest = std::max(largest, std::abs(moved));
  }
  return largest;
}

/// The largest distance of a node between two arrays with `dimension` numbers each.
double largestDistance(const std::vector<double>& a, const std::vector<double>& b, std::size_t dimension) {
  double largest = 0.0;
  for (std::size_t node = 0; node < a.size(); node += dimension) {
    double squares = 0.0;
    for (std::size_t c = 0; c < dimension; ++c) squares += (a[node + c] - b[node + c]) * (a[node + c] - b[node + c]);
    largest = std::max(largest, squares);
  }
  return std::sqrt(largest);
}

}  // namespace

void Sizes::include(const Sizes& other) {
  position = std::max(position, other.position);
  velocity = std::max(velocity, other.velocity);
  outputs.resize(std::max(outputs.size(), other.outputs.size()), 0.0);
  for (std::size_t i = 0; i < other.outputs.size(); ++i) outputs[i] = std::max(outputs[i], other.outputs[i]);
}

std::vector<std::size_t> comparedRows(const Trajectory& trajectory) {
  const std::size_t last = trajectory.t.size() - 1;
  const std::size_t stride = 1 + last / mostComparedRows;
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < last; row += stride) rows.push_back(row);
  rows.push_back(last);
  return rows;
}

Sizes nodeMotion(const ModelSystem& system, const Trajectory& trajectory) {
  Sizes sizes;
  MotionFrame frame(system, {trajectory.t[0], trajectory.x[0], trajectory.v[0], {}});
  for (std::size_t row = 0; row < trajectory.t.size(); ++row) {
    const ErrorScale size = frame.sizeAt(system, {trajectory.t[row], trajectory.x[row], trajectory.v[row], {}});
    sizes.position = std::max(sizes.position, size.position);
    sizes.velocity = std::max(sizes.velocity, size.velocity);
  }
  return sizes;
}

Sizes motionOf(const Scene& scene, const ModelSystem& system, const Trajectory& trajectory) {
  Sizes sizes = nodeMotion(system, trajectory);
  const MotionFrame frame(system, {trajectory.t[0], trajectory.x[0], trajectory.v[0], {}});
  const std::vector<const SceneOutput*> outputs = measuredOutputs(scene);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    sizes.outputs.push_back(outputMotion(*outputs[i], trajectory.t, valuesOf(trajectory, outputs.size(), i),
                                         driftAlong(scene.model, frame, *outputs[i])));
  }
  return sizes;
}

Sizes differenceOf(const Scene& scene, const ModelSystem& system, const Trajectory& a,
                   const std::vector<std::size_t>& rows, const Trajectory& b) {
  if (b.t.size() != rows.size()) throw std::logic_error("the runs compared have not the same outputs");
  Sizes sizes;
  const auto dimension = static_cast<std::size_t>(system.dimension());
  const std::size_t outputs = measuredOutputs(scene).size();
  sizes.outputs.assign(outputs, 0.0);
  std::vector<double> xa, va, xb, vb;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    system.everyNode({a.t[rows[i]], a.x[rows[i]], a.v[rows[i]], {}}, xa, va);
    system.everyNode({b.t[i], b.x[i], b.v[i], {}}, xb, vb);
    sizes.position = std::max(sizes.position, largestDistance(xa, xb, dimension));
    sizes.velocity = std::max(sizes.velocity, largestDistance(va, vb, dimension));
    for (std::size_t j = 0; j < outputs; ++j) {
      const double difference = valuesOf(a, outputs, j)[rows[i]] - valuesOf(b, outputs, j)[i];
      sizes.outputs[j] = std::max(sizes.outputs[j], std::abs(difference));
    }
  }
  return sizes;
}

}  // namespace muelle::lab
