#pragma once
#include "engine/model/model.h"

#include <string>
#include <vector>

namespace muelle::bench {

/// What a scene is, as the bars tell scenes apart.
enum class SceneKind {
  Small,    ///< under 100 unknowns
  Grid,     ///< 100 unknowns and more, springs in rows of equal strides: chain, cloth, drum
  General,  ///< 100 unknowns and more, springs of any topology
  Damped,   ///< damping, not stiffness, bounds the step of explicit methods
  Bounce,   ///< contact alone
};

/// A scene of the sweep: physics that the engine and its peers both can run, without friction or random numbers.
struct BenchScene {
  std::string name;  ///< "cloth_32": as --scene names it
  std::string title;
  engine::Model model = {};
  /// The same physics in the order that a peer likes best; empty: `model`.
  engine::Model peerModel = {};
  std::vector<std::size_t> placeOfPeerNode = {};  ///< the number in `model` of each node of peerModel
  double duration = 1.0;                          ///< [s]
  SceneKind kind = SceneKind::Small;
  bool locateEvents = true;  ///< whether our methods end their steps at contacts
  bool quick = false;        ///< whether --quick runs it
  int samples = 100;         ///< how often along the run the error is looked at

  double quickDuration = 0.0;  ///< [s] with --quick; 0: the same

  /// How many equal steps of about h [s] fill the duration: so many that the samples fall on ends of steps, or all ends
  /// of steps on samples.
  long long stepsOf(double h) const;
  const engine::Model& modelOfPeers() const { return peerModel.nodes.empty() ? model : peerModel; }
};

/// The names of all scenes, in the order of the tables.
std::vector<std::string> sceneNames();

/// Throws std::invalid_argument with the nearest name.
BenchScene makeScene(const std::string& name);

/// Degrees of freedom that nothing holds.
int unknownsOf(const engine::Model& model);

/// A square cloth of `n` x `n` nodes, 1 m and 1 kg, that hangs from its two upper corners: structural, shear and
/// bending springs of stiffness k [N/m] and projected damping d [kg/s], each node with a drag of `drag` [1/s] times its
/// mass. It starts as a wave of 0.15 m across, in which every spring has its rest length.
engine::Model waveCloth(int n, double k, double d, double drag);

/// The same physics with nodes and springs in a random order (fixed seed); place[i] is the new number of node i.
engine::Model shuffled(const engine::Model& model, std::vector<std::size_t>& place);

}  // namespace muelle::bench
