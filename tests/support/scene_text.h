#pragma once
#include "base/file.h"
#include "engine/scene/scene.h"

#include <gtest/gtest.h>
#include <algorithm>
#include <string>

namespace muelle::engine {

/// Reads a scene from text, as the file "scenes/test.toml".
inline Scene sceneFrom(const std::string& text) {
  const TemporaryFolder folder(::testing::TempDir());
  std::filesystem::create_directories(folder.path() / "scenes");
  writeFile(folder.path() / "scenes" / "test.toml", text);
  return readScene(folder.path() / "scenes" / "test.toml");
}

/// The message of what reading the text throws, its file as "scenes/test.toml"; "" when it throws nothing.
inline std::string complaintAbout(const std::string& text) {
  try {
    sceneFrom(text);
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    return message.substr(std::min(message.find("scenes/test.toml"), message.size()));
  }
  return "";
}

/// What every scene needs; five lines.
inline const std::string head =
    "title = 'A test'\nshows = 'nothing'\nslide = 'Ley de Hooke'\ndimension = 1\ngravity = 0.0\n";
inline const std::string run = "[run]\nmethod = 'velocity_verlet'\nstep = 0.01\nduration = 1.0\n";
inline const std::string pair = "[[node]]\nx = 0.0\npinned = true\n[[node]]\nx = 1.2\nm = 1.0\n";

}  // namespace muelle::engine
