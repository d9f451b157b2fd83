#include "lab/run/foresight.h"
#include "lab/run/run_scene.h"
#include "support/scene_text.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <functional>
#include <limits>

namespace muelle::lab {

using namespace engine;
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double MiB = 1024.0 * 1024.0;

Scene cloth(const std::string& method, const std::string& more) {
  return sceneFrom(
      "title = 'A'\nshows = 'b'\nslide = 'c'\n[[object]]\nkind = 'grid'\nnodes = [100, 100]\nspacing = 0.1\nk = 1\n"
      "mass = 1\n[run]\nmethod = '" +
      method + "'\nstep = 0.001\nduration = 10\n" + more);
}

std::string refusalOf(const Scene& scene, double available) {
  try {
    runScene(scene, {}, available);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Foresight, CountsStepsOutputsAndWhatAnOutputTakes) {
  const Foresight every = foresee(cloth("velocity_verlet", ""));
  EXPECT_EQ(every.steps, 10000.0);
  EXPECT_EQ(every.outputs, 10001.0);
  EXPECT_EQ(every.unknowns, 30000.0);
  // 10^4 nodes, 3 coordinates padded to 4, positions and velocities, 8 bytes each; the time.
  EXPECT_EQ(every.output, 640000.0 + 8.0);
  EXPECT_EQ(every.matrices, 0.0);
  EXPECT_EQ(foresee(cloth("velocity_verlet", "output_interval = 0.1\n")).outputs, 101.0);
  EXPECT_FALSE(foresee(cloth("dop853", "tolerance = 1e-6\n")).steps);
  // 10^4 nodes and 19800 springs, two copies: at least 2 (10^4 + 2 x 19800) blocks of 9 numbers.
  EXPECT_EQ(foresee(cloth("bdf2", "")).matrices, 2.0 * 49600.0 * 72.0);
}

TEST(Foresight, RefusesOutputsBeyondTheMemoryThatIsThere) {
  // 1000 outputs of 640 kB, the fewest that thinning leaves of 10001, are 610 MiB.
  EXPECT_THAT(refusalOf(cloth("velocity_verlet", ""), 400.0 * MiB),
              AllOf(HasSubstr("needs at least 6"), HasSubstr("400 MiB are there"), HasSubstr("10,000 nodes"),
                    HasSubstr("610 MiB for 1,000 outputs (of 10,001 outputs; fewer are never kept) in 10,000 steps"),
                    HasSubstr("give a longer output_interval")));
}

TEST(Foresight, RefusesASystemBeyondTheMemoryThatIsThere) {
  EXPECT_THAT(refusalOf(cloth("velocity_verlet", "output_interval = 10\n"), 2.0 * MiB),
              AllOf(HasSubstr("2 MiB are there"), HasSubstr("for 2 outputs"), HasSubstr("; make the scene smaller")));
  EXPECT_THAT(refusalOf(cloth("bdf2", "output_interval = 10\n"), 8.0 * MiB), HasSubstr("6.81 MiB for matrices"));
}

TEST(Foresight, LetsARunGoOnThatHasRoomForFewerOutputs) {
  const Scene scene =
      sceneFrom(head + pair + "[[spring]]\nnodes = [0, 1]\nk = 100.0\n[run]\nmethod = 'velocity_verlet'\n" +
                "step = 0.0001\nduration = 1.0\n");
  const double room = foresee(scene).least() + 0.1 * MiB;
  const SceneRun run = runScene(scene, {}, room);
  EXPECT_FALSE(run.result.failed());
  EXPECT_LT(run.result.trajectory.t.size(), 5001u) << "10001 outputs do not fit; every second one is dropped, or more";
  EXPECT_EQ(run.result.trajectory.t.back(), 1.0);
}

/// The most memory [byte] that a process of its own has at any time while it does something.
double peakOf(const std::function<void()>& work) {
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  rusage usage{};
  EXPECT_EQ(wait4(child, &status, 0, &usage), child);
  EXPECT_EQ(status, 0);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

// 10^4 nodes; what a process has before it does anything is not the run's.
TEST(Foresight, TellsThePeakOfTheMemoryWithinAFactorOfOneAndAHalf) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer keeps memory of its own";
#endif
  for (const char* method : {"velocity_verlet", "backward_euler"}) {
    for (const double damping : {0.0, 1e-3}) {
      Scene scene = cloth(method, "output_interval = 0.001\n");
      for (ModelSpring& spring : scene.model.springs) spring.dRelative = damping;
      scene.duration = 0.003;
      const double nothing = peakOf([] {});
      const double measured = peakOf([&scene] { runScene(scene); }) - nothing;
      const Foresight foresight = foresee(scene);
      // The scene itself is there before.
      const double scenes = 0.25 * foresight.model;
      const double told = foresight.peak(roomForOutputs(foresight, 1e12)) - scenes;
      EXPECT_GT(told, measured / 1.5) << method << " " << damping << " " << measured / MiB << " MiB";
      EXPECT_LT(told, measured * 1.5) << method << " " << damping << " " << measured / MiB << " MiB";
    }
  }
}

TEST(Foresight, SaysWhatALongRunWillTakeAndOfAShortOneThatItIsShort) {
  const Foresight foresight = foresee(cloth("velocity_verlet", "output_interval = 0.1\n"));
  const double room = roomForOutputs(foresight, 1e12);
  EXPECT_THAT(foreseenText(foresight, room), HasSubstr("foreseen: about 10,000 steps, 101 outputs, about "));
  EXPECT_TRUE(foresight.isLong(room)) << "10^4 steps of 3 10^4 unknowns";
  Scene shorter = cloth("velocity_verlet", "output_interval = 0.1\n");
  shorter.duration = 0.1;
  EXPECT_FALSE(foresee(shorter).isLong(room));
  EXPECT_THAT(foreseenText(foresee(cloth("dop853", "tolerance = 1e-6\n")), room),
              HasSubstr("as many steps as the tolerance asks for, about "));
}

TEST(Foresight, ReadsWhatTheSystemSaysIsAvailable) {
  const TemporaryFolder folder(::testing::TempDir());
  writeFile(folder.path() / "meminfo", "MemTotal:  900 kB\nMemFree:   1 kB\nMemAvailable:   3 kB\n");
  EXPECT_EQ(availableMemory(folder.path() / "meminfo"), 3.0 * 1024.0);
  EXPECT_GT(availableMemory(folder.path() / "none"), 3.0 * 1024.0);
}

}  // namespace
}  // namespace muelle::lab
