#include "harness/trajectory.h"

#include "base/file.h"
#include "base/text/csv.h"
#include "base/text/nearest.h"

#include <fmt/format.h>
#include <iterator>
#include <stdexcept>

namespace muelle {

namespace {

std::vector<double> column(const std::vector<std::vector<double>>& rows, int i, const char* what) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const std::vector<double>& row : rows) {
    if (i < 0 || static_cast<std::size_t>(i) >= row.size()) {
      throw std::out_of_range(fmt::format("Trajectory: {} {} of {} degrees of freedom", what, i, row.size()));
    }
    values.push_back(row[static_cast<std::size_t>(i)]);
  }
  return values;
}

std::string csvHeader(const Trajectory& trajectory, const std::string& axes) {
  const std::size_t size = trajectory.x.empty() ? 0 : trajectory.x.front().size();
  if (axes.empty() || size % axes.size() != 0) {
    throw std::invalid_argument(
        fmt::format("writeCsv: {} coordinates are no whole number of nodes with the axes '{}'", size, axes));
  }
  std::string header = "t [s]";
  const auto addHeads = [&](const char* quantity, const char* unit) {
    for (std::size_t i = 0; i < size; ++i) {
      header += fmt::format(",node {} {}{} [{}]", i / axes.size(), quantity, axes[i % axes.size()], unit);
    }
  };
  addHeads("", "m");
  addHeads("v", "m/s");
  for (const Track& track : trajectory.tracks) {
    header += ',' + csvField(fmt::format("{} [{}]", track.name, track.unit));
  }
  return header + '\n';
}

}  // namespace

std::vector<double> Trajectory::position(int i) const { return column(x, i, "position"); }
std::vector<double> Trajectory::velocity(int i) const { return column(v, i, "velocity"); }

const std::vector<double>& Trajectory::track(const std::string& name) const {
  std::vector<std::string> known;
  for (const Track& candidate : tracks) {
    if (candidate.name == name) return candidate.values;
    known.push_back(candidate.name);
  }
  throw std::out_of_range(
      fmt::format("Trajectory: no probe '{}'{}", name, known.empty() ? "; there are none" : suggestion(name, known)));
}

State Trajectory::last() const {
  if (t.empty()) throw std::out_of_range("Trajectory: no state was recorded");
  return {t.back(), x.back(), v.back(), {}};
}

void writeCsv(const Trajectory& trajectory, const std::string& axes, const std::filesystem::path& file) {
  std::string text = csvHeader(trajectory, axes);
  for (std::size_t row = 0; row < trajectory.t.size(); ++row) {
    text += fmt::format("{}", trajectory.t[row]);  // the shortest text that reads back as the same number
    for (const double value : trajectory.x[row]) text += fmt::format(",{}", value);
    for (const double value : trajectory.v[row]) text += fmt::format(",{}", value);
    for (const Track& track : trajectory.tracks) text += fmt::format(",{}", track.values[row]);
    text += '\n';
  }
  writeFile(file, text);
}

}  // namespace muelle
