#pragma once
#include "engine/control/simulate.h"
#include "engine/model/model_system.h"
#include "engine/scene/generators.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace muelle::engine {

/// Something that a scene measures along its run; the energies are always measured.
struct SceneOutput {
  enum class Kind {
    Position,      ///< a node's component [m]
    Velocity,      ///< a node's component [m/s]
    MeanPosition,  ///< mean over the nodes of a component [m]
    Lowest,        ///< least component of the nodes [m]
    Highest,       ///< greatest component of the nodes [m]
    Distance,      ///< between two nodes [m]
    Path,          ///< a node's path in the view's plane, drawn as a figure of its own; no column of numbers
  };
  Kind kind = Kind::Position;
  std::string name;        ///< "height of node 12"
  std::vector<int> nodes;  ///< in the model's numbering
  int axis = 2;            ///< component: 0, 1, 2 for x, y, z
};

/// A scene: what is simulated, how, and what is measured. (docs/scenes.md describes the files.)
struct Scene {
  std::string name;   ///< of the file, without .toml
  std::string title;  ///< one line
  std::string shows;  ///< what there is to see
  std::string slide;  ///< title of the slide of the lecture
  Model model;
  std::vector<Part> parts;                                       ///< what the generators made, in the order of the file
  std::string method;                                            ///< id of the catalogue
  double duration = 1.0;                                         ///< [s]
  std::optional<double> step;                                    ///< [s] of methods without an error estimate
  std::optional<double> tolerance;                               ///< relative, of methods with one
  double largestStep = std::numeric_limits<double>::infinity();  ///< [s]
  double outputInterval = 0.0;                                   ///< [s]; 0: every step
  bool locateEvents = true;
  bool compensated = false;
  std::vector<SceneOutput> outputs;
  std::vector<std::string> warnings;  ///< what was read and is perhaps not meant, a sentence each
  std::array<int, 2> view = {0, 2};   ///< components that figures show across and up
};

/// Reads a scene file. Throws std::runtime_error "FILE.toml:LINE: key 'KEY': what is wrong", the file as it was
/// given, with what was expected and the nearest known name.
Scene readScene(const std::filesystem::path& file);

/// The scene files of a folder, by name.
std::vector<std::filesystem::path> listScenes(const std::filesystem::path& folder);

/// A scene's file by its name in `folder`, or by its path: whatever has a slash or ends in .toml. Throws
/// std::runtime_error with the nearest known name.
std::filesystem::path findScene(const std::string& nameOrPath, const std::filesystem::path& folder);

/// The probes of a built scene: kinetic, potential and total energy, then the scene's outputs but the paths.
/// `system` must live as long as they are used.
std::vector<Probe> probesOf(const Scene& scene, const ModelSystem& system);

}  // namespace muelle::engine
