#include "engine/forces/segment.h"
#include "engine/model/damping.h"
#include "engine/model/parts.h"
#include "support/scene_text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <cmath>
#include <numbers>

namespace muelle::engine {
namespace {

struct Fault {
  std::string name;
  std::string text;
  std::string message;  ///< whole
};

std::string space(const std::string& text) { return "title = 'A test'\nshows = 'nothing'\nslide = 'x'\n" + text + run; }

const std::vector<Fault>& faults() {
  static const std::string spring = "[[spring]]\nnodes = [0, 1]\nk = 100.0\n";
  static const std::string grid =
      "[[object]]\nkind = 'grid'\nname = 'cloth'\nnodes = [3, 3]\nspacing = 0.1\nmass = 1\n";
  static const std::vector<Fault> all = {
      {"Syntax", "title = \n", "scenes/test.toml:1: Error while parsing key-value pair: expected value, saw '\\n'"},
      {"MisspeltTopLevel", head + "[[sprng]]\nk = 1\n" + run,
       "scenes/test.toml:6: key 'sprng': unknown; did you mean 'spring'?"},
      {"MissingTitle", "shows = 'nothing'\nslide = 'x'\n" + run,
       "scenes/test.toml:1: key 'title': missing in the scene"},
      {"MisspeltKey", head + pair + "[[spring]]\nnodes = [0, 1]\nk = 1\nrelative_dampng = 2\n" + run,
       "scenes/test.toml:15: key 'relative_dampng': unknown; did you mean 'relative_damping'?"},
      {"ChainOfRodsWithStiffness",
       head + "[[object]]\nkind = 'chain'\nnodes = 3\nfrom = 0.0\nto = 1.0\nmass = 1\nrod = true\nk = 1\n" + run,
       "scenes/test.toml:13: key 'k': a rod has no stiffness: leave k or rod out"},
      {"BoxOfRods",
       head + "[[object]]\nkind = 'box'\ncells = [1, 1, 1]\nsize = [1, 1, 1]\nmass = 1\nrod = true\n" + run,
       "scenes/test.toml:11: key 'rod': unknown; there are kind, name, mass, density, k, relative_damping, "
       "projected_damping, damping_ratio, drag, velocity, spin, turn, translation, cells, size, centre, bulk_modulus"},
      {"NodeOutOfAnObject",
       head + "[[object]]\nkind = 'chain'\nname = 'c'\nnodes = 3\nfrom = 0.0\nto = 1.0\nk = 1\nmass = 1\n" +
           "[[pin]]\nobject = 'c'\nnodes = [-1]\n" + run,
       "scenes/test.toml:16: key 'nodes': there is no node -1; object 'c' has 3 nodes, numbered from 0"},
      {"ObjectOfAnotherName",
       head + "[[object]]\nkind = 'chain'\nname = 'c'\nnodes = 3\nfrom = 0.0\nto = 1.0\nk = 1\nmass = 1\n" +
           "[[pin]]\nobject = 'rope'\nnodes = [1]\n" + run,
       "scenes/test.toml:15: key 'object': no object 'rope'; there is c"},
      {"KeyByAnotherName", head + pair + spring + "[run]\nintegrator = 'velocity_verlet'\ndt = 0.01\nduration = 1\n",
       "scenes/test.toml:16: key 'integrator': unknown; here it is 'method'"},
      {"KindOfAnObstacle", head + pair + "[[obstacle]]\nkind = 'plane'\npoint = 0.0\nk = 1.0\n" + run,
       "scenes/test.toml:13: key 'kind': unknown; here it is 'shape'"},
      {"MassOfANode", head + "[[node]]\nx = 0.0\nmass = 1.0\n" + run,
       "scenes/test.toml:8: key 'mass': unknown; here it is 'm'"},
      {"RodWithStiffness", head + pair + "[[spring]]\nnodes = [0, 1]\nrod = true\nk = 1\n" + run,
       "scenes/test.toml:15: key 'k': a rod has no stiffness: leave k or rod out"},
      {"TextForNumber", head + "[[node]]\nx = 'here'\nm = 1\n" + run,
       "scenes/test.toml:7: key 'x': expected a number, found a text"},
      {"NegativeMass", head + "[[node]]\nx = 0.0\nm = -1.0\n" + run,
       "scenes/test.toml:8: key 'm': is -1; it must be positive"},
      {"NoMass", head + "[[node]]\nx = 0.0\n" + run,
       "scenes/test.toml:6: key 'm': missing: a node that is neither pinned nor moved has a mass"},
      {"NanPosition", head + "[[node]]\nx = nan\nm = 1\n" + run, "scenes/test.toml:7: key 'x': is not a number"},
      {"InfiniteVelocity", head + "[[node]]\nx = 0.0\nv = inf\nm = 1\n" + run,
       "scenes/test.toml:8: key 'v': must be finite"},
      {"NegativeStiffness", head + pair + "[[spring]]\nnodes = [0, 1]\nk = -1.0\n" + run,
       "scenes/test.toml:14: key 'k': is -1; it must not be negative"},
      {"NodeOutOfRange", head + pair + "[[spring]]\nnodes = [0, 2]\nk = 1.0\n" + run,
       "scenes/test.toml:13: key 'nodes': there is no node 2; the scene has 2 nodes, numbered from 0"},
      {"SpringWithItself", head + pair + "[[spring]]\nnodes = [1, 1]\nk = 1.0\n" + run,
       "scenes/test.toml:13: key 'nodes': a node stands twice"},
      {"WrongVectorLength", space("[[node]]\nx = [0.0, 1.0]\nm = 1\n"),
       "scenes/test.toml:5: key 'x': expected a list of 3 numbers, found 2"},
      {"FourDimensions", "title = 't'\nshows = 's'\nslide = 'x'\ndimension = 4\n" + run,
       "scenes/test.toml:4: key 'dimension': 4 does not lie between 1 and 3"},
      {"UnknownPrecision", "title = 't'\nshows = 's'\nslide = 'x'\nprecision = 'half'\n" + run,
       "scenes/test.toml:4: key 'precision': 'half' is none; expected \"double\" or \"single\""},
      {"NoNodes", head + run, "scenes/test.toml:1: the scene: has no nodes; [[node]] and [[object]] make them"},
      {"UnknownMethod", head + pair + spring + "[run]\nmethod = 'velocity_verlt'\nstep = 0.01\nduration = 1\n",
       "scenes/test.toml:16: key 'method': no method 'velocity_verlt'; did you mean 'velocity_verlet'?"},
      {"NoStep", head + pair + spring + "[run]\nmethod = 'velocity_verlet'\nduration = 1\n",
       "scenes/test.toml:15: key 'step': missing: velocity_verlet needs a step [s]"},
      {"ZeroStep", head + pair + spring + "[run]\nmethod = 'velocity_verlet'\nstep = 0.0\nduration = 1\n",
       "scenes/test.toml:17: key 'step': is 0; it must be positive"},
      {"NegativeDuration", head + pair + spring + "[run]\nmethod = 'velocity_verlet'\nstep = 0.1\nduration = -1\n",
       "scenes/test.toml:18: key 'duration': is -1; it must be positive"},
      {"TooManyNodes", space("[[object]]\nkind = 'grid'\nnodes = [100000, 100000]\nspacing = 0.1\nmass = 1\nk = 1\n"),
       "scenes/test.toml:4: [[object]]: 10000000000 nodes; at most 2000000 are built"},
      {"MassAndDensity", space(grid + "density = 1\nk = 1\n"),
       "scenes/test.toml:10: key 'density': goes not together with 'mass': give one of mass, density"},
      {"UnknownKind", space("[[object]]\nkind = 'gird'\nmass = 1\nk = 1\n"),
       "scenes/test.toml:5: key 'kind': 'gird' is unknown; did you mean 'grid'?"},
      {"UnknownObject", space(grid + "k = 1\n[[pin]]\nobject = 'cloht'\nall = true\n"),
       "scenes/test.toml:12: key 'object': no object 'cloht'; did you mean 'cloth'?"},
      {"NoSelection", space(grid + "k = 1\n[[pin]]\nobject = 'cloth'\n"),
       "scenes/test.toml:11: [[pin]]: one of the keys nodes, within, corner, all is needed"},
      {"EmptyBox", space(grid + "k = 1\n[[pin]]\nwithin = [[1, 1, 1], [2, 2, 2]]\n"),
       "scenes/test.toml:12: key 'within': chooses no node"},
      {"WrongCorner", space(grid + "k = 1\n[[pin]]\ncorner = 'left'\n"),
       "scenes/test.toml:12: key 'corner': 'left' is no corner; expected signs with axes of x, y, z, as in \"-x +z\""},
      {"MissingMesh", space("[[object]]\nkind = 'shell'\nmesh = 'none.off'\nmass = 1\nk = 1\n"),
       "scenes/test.toml:6: key 'mesh': no file 'none.off' beside the scene; there are none"},
      {"NormalOfLengthZero",
       space("[[node]]\nx = [0, 0, 0]\nm = 1\n[[obstacle]]\nshape = 'plane'\npoint = [0, 0, 0]\n"
             "normal = [0, 0, 0]\nk = 1\n"),
       "scenes/test.toml:10: key 'normal': has length 0; it gives a direction"},
      {"ReversedInterval", head + pair + "[[force]]\nnodes = [1]\nF = 1.0\nduring = [2, 1]\n" + run,
       "scenes/test.toml:15: key 'during': [2, 1] is no interval 0 <= t0 < t1"},
      {"MovedTwice", head + pair + "[[motion]]\nnodes = [0]\nvelocity = 1.0\n" + run,
       "scenes/test.toml:12: [[motion]]: node 0 is pinned or moved already"},
      {"AxisOfAnotherSpace", head + pair + "[[output]]\nkind = 'position'\nname = 'h'\nnodes = [1]\naxis = 'z'\n" + run,
       "scenes/test.toml:16: key 'axis': 'z' is unknown; did you mean 'x'?"},
  };
  return all;
}

class BadScene : public ::testing::TestWithParam<Fault> {};

TEST_P(BadScene, IsRefusedWithFileLineAndKey) { EXPECT_EQ(complaintAbout(GetParam().text), GetParam().message); }

INSTANTIATE_TEST_SUITE_P(, BadScene, ::testing::ValuesIn(faults()), [](const auto& test) { return test.param.name; });

TEST(SceneReader, ReadsNodesAndSpringsByHand) {
  const Scene scene = sceneFrom(head + pair + "[[spring]]\nnodes = [0, 1]\nk = 100.0\nL0 = 1\ndamping_ratio = 0.5\n" +
                                "[[output]]\nkind = 'position'\nname = 'x'\nnodes = [1]\naxis = 'x'\n" + run);
  EXPECT_EQ(scene.name, "test");
  ASSERT_EQ(scene.model.nodes.size(), 2u);
  EXPECT_TRUE(scene.model.nodes[0].pinned);
  EXPECT_EQ(scene.model.nodes[1].x, Vec3(1.2, 0, 0));
  ASSERT_EQ(scene.model.springs.size(), 1u);
  EXPECT_EQ(scene.model.springs[0].L0, 1.0);
  // The pinned end is infinitely heavy: d = 2 zeta sqrt(k m) = 2 * 0.5 * sqrt(100 * 1).
  EXPECT_DOUBLE_EQ(projectedDamping(scene.model, scene.model.springs[0]), 10.0);
  EXPECT_EQ(scene.method, "velocity_verlet");
  EXPECT_EQ(scene.step, 0.01);
  EXPECT_FALSE(scene.tolerance);
}

/// A mass of 4 kg on a spring to a node that is held, in one way or another.
Scene heldBy(const std::string& nodeKey, const std::string& table) {
  return sceneFrom(head + "[[node]]\nx = 0.0\n" + nodeKey + "[[node]]\nx = 1.2\nm = 4.0\n[[spring]]\nnodes = [0, 1]\n" +
                   "k = 100.0\nL0 = 1.0\ndamping_ratio = 0.1\n" + table + run);
}

TEST(SceneReader, ADampingRatioIsTheSameInWhateverWayTheOtherNodeIsHeld) {
  const std::pair<std::string, std::string> ways[] = {
      {"pinned = true\n", ""},
      {"m = 4.0\npinned = true\n", ""},
      {"m = 4.0\n", "[[pin]]\nnodes = [0]\n"},
      {"", "[[pin]]\nnodes = [0]\n"},
      {"", "[[motion]]\nnodes = [0]\ndisplacement = 0.1\nduring = [0.0, 1.0]\n"}};
  for (const auto& [key, table] : ways) {
    const Scene scene = heldBy(key, table);
    // d = 2 z sqrt(k m) = 2 * 0.1 * sqrt(100 * 4)
    EXPECT_DOUBLE_EQ(projectedDamping(scene.model, scene.model.springs[0]), 4.0) << key << table;
  }
}

TEST(SceneReader, PartsAreNamedByTheirObjectOrByHand) {
  const Scene scene =
      sceneFrom(space("[[node]]\nx = [0, 0, 1]\nm = 1\n[[node]]\nx = [0, 0, 2]\nm = 1\n"
                      "[[object]]\nkind = 'chain'\nname = 'rope'\nnodes = 3\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nk = "
                      "1\nmass = 1\nangle_stiffness = 1\n"
                      "[[spring]]\nnodes = [0, 1]\nk = 1\npart = 'hem'\n[[spring]]\nnodes = [1, 2]\nk = 1\n"
                      "[[force]]\nF = [1, 0, 0]\nall = true\npart = 'wind'\n"));
  std::vector<std::string> names;
  for (const ModelPart& part : partsOf(scene.model)) names.push_back(part.name);
  EXPECT_EQ(names, (std::vector<std::string>{"rope.structural", "hem", "spring", "rope.angle", "wind"}));
}

TEST(SceneReader, RestLengthIsTheDistanceWhenNotGiven) {
  const Scene scene = sceneFrom(head + pair + "[[spring]]\nnodes = [0, 1]\nk = 100.0\n" + run);
  EXPECT_DOUBLE_EQ(scene.model.springs[0].L0, 1.2);
}

TEST(SceneReader, VectorsOfAPlaneGoToItsAxes) {
  const Scene scene = sceneFrom(
      "title = 't'\nshows = 's'\nslide = 'x'\ndimension = 2\nplane = 'yz'\ngravity = 9.81\n"
      "[[node]]\nx = [1.0, 2.0]\nm = 1\n" +
      run);
  EXPECT_EQ(scene.model.nodes[0].x, Vec3(0, 1, 2));
  EXPECT_EQ(scene.model.gravity, Vec3(0, 0, -9.81));
}

const std::string cloth =
    "[[object]]\nkind = 'grid'\nname = 'cloth'\nnodes = [4, 3]\nspacing = 0.5\nmass = 1.2\nk = 10\n";

std::vector<int> pinnedOf(const Scene& scene) {
  std::vector<int> pinned;
  for (std::size_t i = 0; i < scene.model.nodes.size(); ++i) {
    if (scene.model.nodes[i].pinned) pinned.push_back(static_cast<int>(i));
  }
  return pinned;
}

TEST(Selection, CornerIsTheNodesAtTheExtremes) {
  EXPECT_THAT(pinnedOf(sceneFrom(space(cloth + "[[pin]]\ncorner = '-x +y'\n"))), ::testing::ElementsAre(8));
  EXPECT_THAT(pinnedOf(sceneFrom(space(cloth + "[[pin]]\ncorner = '+x'\n"))), ::testing::ElementsAre(3, 7, 11));
}

TEST(Selection, BoxTakesItsOwnFacesIn) {
  const Scene scene = sceneFrom(space(cloth + "[[pin]]\nwithin = [[0.5, 0.0, 0.0], [1.0, 0.5, 0.0]]\n"));
  EXPECT_THAT(pinnedOf(scene), ::testing::ElementsAre(1, 2, 5, 6));
}

TEST(Selection, IndicesCountWithinAnObjectAndHandMadeNodesComeFirst) {
  const Scene scene =
      sceneFrom(space(cloth + "[[pin]]\nobject = 'cloth'\nnodes = [0]\n[[node]]\nx = [9, 9, 9]\nm = 1\n"));
  EXPECT_THAT(pinnedOf(scene), ::testing::ElementsAre(1));
}

TEST(Motion, IsSmoothAndItsVelocityIsItsDerivative) {
  const Scene scene =
      sceneFrom(space("[[node]]\nx = [1, 0, 0]\nm = 1\n[[node]]\nx = [2, 0, 0]\nm = 1\n[[node]]\nx = [3, 0, 0]\nm = 1\n"
                      "[[motion]]\nnodes = [0]\ndisplacement = [2, 0, 1]\nduring = [1.0, 3.0]\n"
                      "[[motion]]\nnodes = [1]\namplitude = [0, 0.5, 0]\nfrequency = 2.0\nduring = [0.0, 0.6]\n"
                      "[[motion]]\nnodes = [2]\nvelocity = [0, 0, -3]\nduring = [0.5, 1.5]\n"));
  ASSERT_EQ(scene.model.motions.size(), 3u);
  const std::vector<Motion>& motions = scene.model.motions;
  const auto at = [](const Motion& motion, double t) { return motion.position(t, segmentAt(motion.times, t)); };
  EXPECT_EQ(at(motions[0], 0.5), Vec3(1, 0, 0));
  EXPECT_EQ(at(motions[0], 2.0), Vec3(2, 0, 0.5));  // half the way at half the time
  EXPECT_EQ(at(motions[0], 9.0), Vec3(3, 0, 1));
  EXPECT_NEAR(at(motions[1], 0.125)[1], 0.5, 1e-15);  // a quarter of the period
  EXPECT_EQ(at(motions[2], 9.0), Vec3(3, 0, -3));
  for (const Motion& motion : motions) {
    for (const double t : {0.3, 1.2, 2.7, 4.0}) {
      const double e = 1e-6;  // central difference: e^2 times the third derivative (2 pi f)^3 / 2 = 1e3, below 1e-8
      const Vec3 difference = (at(motion, t + e) - at(motion, t - e)) / (2 * e);
      EXPECT_LT((difference - motion.velocity(t, segmentAt(motion.times, t))).norm(), 1e-8) << t;
    }
  }
}

TEST(Force, PulseActsBetweenItsDeclaredTimes) {
  const Scene scene = sceneFrom(head + pair + "[[force]]\nnodes = [1]\nF = 1000.0\nduring = [1.0, 1.001]\n" + run);
  const ModelExternalForce& force = scene.model.externalForces.at(0);
  EXPECT_THAT(force.times, ::testing::ElementsAre(1.0, 1.001));
  EXPECT_EQ(force.force(1.0, 0)[0], 0.0);  // the near side of the jump
  EXPECT_EQ(force.force(1.0, 1)[0], 1000.0);
  EXPECT_EQ(force.force(1.001, 2)[0], 0.0);
}

TEST(Force, OneThatActsFromTheStartHasNoTimeToPassFirst) {
  const Scene scene = sceneFrom(head + pair + "[[force]]\nnodes = [1]\nF = 2.0\nduring = [0.0, 0.5]\n" + run);
  const ModelExternalForce& force = scene.model.externalForces.at(0);
  EXPECT_THAT(force.times, ::testing::ElementsAre(0.5));
  EXPECT_EQ(force.force(0.0, 0)[0], 2.0);
  EXPECT_EQ(force.force(0.5, 1)[0], 0.0);
}

TEST(Force, SinusoidHasNoJump) {
  const Scene scene = sceneFrom(head + pair + "[[force]]\nnodes = [1]\nF = 2.0\nfrequency = 0.25\n" + run);
  const ModelExternalForce& force = scene.model.externalForces.at(0);
  EXPECT_TRUE(force.times.empty());
  EXPECT_DOUBLE_EQ(force.force(1.0, 0)[0], 2.0);
}

TEST(FindScene, NamesTheNearest) {
  EXPECT_EQ(findScene("oscillator", MUELLE_SCENES).filename(), "oscillator.toml");
  try {
    findScene("oscilator", MUELLE_SCENES);
    FAIL() << "a scene that does not exist was found";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "no scene 'oscilator'; did you mean 'oscillator'?");
  }
  EXPECT_THROW(findScene("missing/scene.toml", MUELLE_SCENES), std::runtime_error);
}

/// What reading a file says; "" when it says nothing.
std::string complaintAboutFile(const std::filesystem::path& file) {
  try {
    readScene(file);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(SceneMessages, NameTheFileAsItWasGiven) {
  const TemporaryFolder folder(::testing::TempDir());
  const std::filesystem::path file = folder.path() / "a" / "deep" / "place" / "test.toml";
  std::filesystem::create_directories(file.parent_path());
  writeFile(file, head + "sprng = 1\n" + run);
  EXPECT_EQ(complaintAboutFile(file), file.string() + ":6: key 'sprng': unknown; did you mean 'spring'?");
  writeFile(file, "title = \n");
  EXPECT_EQ(complaintAboutFile(file).find(file.string() + ":1: "), 0u);
  const std::filesystem::path around = folder.path() / "a" / "deep" / ".." / "deep" / "place" / "test.toml";
  EXPECT_EQ(complaintAboutFile(around).find(around.string() + ":1: "), 0u);
  writeFile(folder.path() / "a" / "mesh.obj", "v 0 0\n");
  writeFile(file,
            "title = 'A test'\nshows = 'nothing'\nslide = 'Malla'\n[[object]]\nkind = 'shell'\nk = 1.0\n"
            "mass = 1.0\nmesh = '../../mesh.obj'\n" +
                run);
  EXPECT_EQ(complaintAboutFile(file), (file.parent_path() / "../../mesh.obj").string() + ":1: a number is missing");
}

TEST(SceneMessages, NameTheMethodThatIsMeant) {
  for (const auto& [word, id] : {std::pair("rk4", "runge_kutta_4"), std::pair("RK45", "dormand_prince_5"),
                                 std::pair("Verlet", "velocity_verlet"), std::pair("dop-853", "dop853")}) {
    const std::string text = head + pair + "[run]\nmethod = '" + word + "'\nstep = 0.01\nduration = 1.0\n";
    EXPECT_EQ(complaintAbout(text),
              fmt::format("scenes/test.toml:13: key 'method': no method '{}'; here it is '{}'", word, id));
  }
}

TEST(SceneMessages, CountsAgreeWithTheirNouns) {
  EXPECT_NE(complaintAbout(head +
                           "[[object]]\nkind = 'chain'\nnodes = 3\nfrom = 0.0\nto = 1.0\nmass = 1.0\nk = 1.0\n"
                           "[[output]]\nkind = 'position'\nname = 'x'\naxis = 'x'\nall = true\n" +
                           run)
                .find("chooses 3 nodes; at most 1 here"),
            std::string::npos);
}

}  // namespace
}  // namespace muelle::engine
