#pragma once
/// \file
/// What a scene answers and counts while a method asks it.

#include "challenge.h"
#include "course/testing/test_function.h"
#include "scenes.h"

#include <cmath>
#include <memory>
#include <string>

namespace scenes {

inline const muelle::TriangleMesh& rabbitMesh() {
  static const muelle::TriangleMesh mesh =
      muelle::readTriangleMesh(MUELLE_EXERCISE_FOLDER "/../mesh_to_springs/rabbit.off");
  return mesh;
}

/// What has been asked so far.
struct Tally {
  long forces = 0, hessians = 0;
  double farthest = 0;          ///< the largest coordinate that was asked about [m], of those that were numbers
  bool hasLostNumbers = false;  ///< one was no number

  long evaluations() const { return forces + hessianWeight * hessians; }

  void lookAt(const VecX& x) {
    for (const double coordinate : x) {
      if (std::isnan(coordinate)) hasLostNumbers = true;
      if (std::abs(coordinate) > farthest) farthest = std::abs(coordinate);
    }
  }
};

/// A scene that counts. It stops whoever asks more often than any band allows, or with vectors of the wrong length.
template <class Scene>
class Asked {
 public:
  explicit Asked(Scene scene) : scene_(std::make_shared<const Scene>(std::move(scene))) {}

  const Scene& scene() const { return *scene_; }
  const Tally& tally() const { return *tally_; }

  Force force() const {
    return [scene = scene_, tally = tally_](double t, const VecX& x, const VecX& v) {
      expectSizes(*scene, x, v);
      ++tally->forces;
      count(*tally, x);
      return scene->force(t, x, v);
    };
  }

  Hessian hessian() const {
    return [scene = scene_, tally = tally_](double t, const VecX& x) {
      expectSizes(*scene, x, x);
      ++tally->hessians;
      count(*tally, x);
      return scene->hessian(t, x);
    };
  }

 private:
  static void expectSizes(const Scene& scene, const VecX& x, const VecX& v) {
    const Eigen::Index n = scene.masses().size();
    if (x.size() == n && v.size() == n) return;
    throw muelle::BadQuestion("asks with " + std::to_string(x.size()) + " positions and " + std::to_string(v.size()) +
                              " velocities, where there are " + std::to_string(n));
  }
  static void count(Tally& tally, const VecX& x) {
    tally.lookAt(x);
    if (tally.evaluations() <= Scene::goal.enough) return;
    throw muelle::BadQuestion("has asked for more than " + std::to_string(Scene::goal.enough) +
                              " evaluations, which is beyond all bands, and was stopped");
  }

  std::shared_ptr<const Scene> scene_;
  std::shared_ptr<Tally> tally_ = std::make_shared<Tally>();
};

}  // namespace scenes
