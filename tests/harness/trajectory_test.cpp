#include "harness/trajectory.h"
#include "base/file.h"
#include "support/temporary.h"

#include <gtest/gtest.h>
#include <cmath>
#include <fstream>
#include <sstream>

namespace muelle {
namespace {

Trajectory example() {
  Trajectory trajectory;
  trajectory.t = {0.0, 0.1, 1.0 / 3.0};
  trajectory.x = {{1.0, 2.0}, {1e-300, -2.5}, {M_PI, 1e300}};
  trajectory.v = {{0.0, -0.0}, {1.0 / 7.0, 3.0}, {-1e-7, 12345678.9}};
  trajectory.tracks = {{"energy, \"total\"", "J", {1.0, 2.0, std::nan("")}}};
  return trajectory;
}

std::vector<std::vector<double>> numbersOf(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);  // the header
  std::vector<std::vector<double>> rows;
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string field;
    rows.emplace_back();
    while (std::getline(fields, field, ',')) rows.back().push_back(std::strtod(field.c_str(), nullptr));
  }
  return rows;
}

TEST(Csv, ReadsBackAsTheSameNumbers) {
  const TemporaryFolder folder(::testing::TempDir());
  const Trajectory trajectory = example();
  writeCsv(trajectory, "x", folder.path() / "run.csv");
  const std::vector<std::vector<double>> rows = numbersOf(readFile(folder.path() / "run.csv"));
  ASSERT_EQ(rows.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(rows[i].size(), 6u);
    EXPECT_EQ(rows[i][0], trajectory.t[i]);
    EXPECT_EQ(rows[i][1], trajectory.x[i][0]);
    EXPECT_EQ(rows[i][2], trajectory.x[i][1]);
    EXPECT_EQ(rows[i][3], trajectory.v[i][0]);
    EXPECT_EQ(rows[i][4], trajectory.v[i][1]);
  }
  EXPECT_EQ(rows[1][5], 2.0);
  EXPECT_TRUE(std::isnan(rows[2][5]));
}

/// The first line that writeCsv leaves.
std::string headsOf(const Trajectory& trajectory, const std::string& axes) {
  const TemporaryFolder folder(::testing::TempDir());
  writeCsv(trajectory, axes, folder.path() / "run.csv");
  const std::string text = readFile(folder.path() / "run.csv");
  return text.substr(0, text.find('\n'));
}

TEST(Csv, NamesColumnsByNodeAndAxisWithTheirUnits) {
  Trajectory run = example();
  EXPECT_EQ(headsOf(run, "x"),
            "t [s],node 0 x [m],node 1 x [m],node 0 vx [m/s],node 1 vx [m/s],\"energy, \"\"total\"\" [J]\"");
  run.tracks.clear();
  EXPECT_EQ(headsOf(run, "xz"), "t [s],node 0 x [m],node 0 z [m],node 0 vx [m/s],node 0 vz [m/s]");
  run.t = {0.0};
  run.x = run.v = {{1, 2, 3, 4, 5, 6}};
  EXPECT_EQ(headsOf(run, "xyz"),
            "t [s],node 0 x [m],node 0 y [m],node 0 z [m],node 1 x [m],node 1 y [m],node 1 z [m],"
            "node 0 vx [m/s],node 0 vy [m/s],node 0 vz [m/s],node 1 vx [m/s],node 1 vy [m/s],node 1 vz [m/s]");
}

TEST(Csv, RefusesAxesThatDoNotDivideTheArrays) {
  const TemporaryFolder folder(::testing::TempDir());
  EXPECT_THROW(writeCsv(example(), "xyz", folder.path() / "run.csv"), std::invalid_argument);
  EXPECT_THROW(writeCsv(example(), "", folder.path() / "run.csv"), std::invalid_argument);
  EXPECT_TRUE(namesIn(folder.path()).empty());
}

TEST(Csv, LeavesNothingWhenItCannotBeWritten) {
  const TemporaryFolder folder(::testing::TempDir());
  EXPECT_THROW(writeCsv(example(), "x", folder.path() / "missing" / "run.csv"), std::runtime_error);
  std::filesystem::create_directory(folder.path() / "run.csv");  // a folder of that name is in the way
  EXPECT_THROW(writeCsv(example(), "x", folder.path() / "run.csv"), std::runtime_error);
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"run.csv"});
}

TEST(Trajectory, GivesOneCoordinateOverTime) {
  const Trajectory trajectory = example();
  EXPECT_EQ(trajectory.position(1), (std::vector<double>{2.0, -2.5, 1e300}));
  EXPECT_EQ(trajectory.velocity(0), (std::vector<double>{0.0, 1.0 / 7.0, -1e-7}));
  EXPECT_THROW(trajectory.position(2), std::out_of_range);
  EXPECT_THROW(trajectory.velocity(-1), std::out_of_range);
}

TEST(Trajectory, NamesTheProbesThatThereAre) {
  try {
    example().track("enrgy");
    FAIL() << "no such probe";
  } catch (const std::out_of_range& error) {
    EXPECT_STREQ(error.what(), "Trajectory: no probe 'enrgy'; there is energy, \"total\"");
  }
}

TEST(Trajectory, GivesItsLastState) {
  const State last = example().last();
  EXPECT_EQ(last.t, 1.0 / 3.0);
  EXPECT_EQ(last.x, (std::vector<double>{M_PI, 1e300}));
  EXPECT_THROW(Trajectory{}.last(), std::out_of_range);
}

}  // namespace
}  // namespace muelle
