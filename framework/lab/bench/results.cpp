#include "lab/bench/results.h"

#include "base/file.h"

#include <fmt/format.h>
#include <algorithm>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace muelle::bench {

namespace {

// The columns of pointsCsv(), in report_csv.cpp.
struct Column {
  enum : std::size_t {
    Scene,
    RowName,
    Library,
    Method,
    Setting,
    Value,
    Ex,
    Ev,
    Evaluations,
    Jacobians,
    Solves,
    Runs,
    Median,
    Least,
    P95,
    Low,
    High,
    Failure
  };
};

/// The fields but for the last, which alone may be quoted, and that as it stands.
std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields;
  std::size_t begin = 0;
  while (fields.size() < Column::Failure) {
    const std::size_t end = line.find(',', begin);
    if (end == std::string::npos) break;
    fields.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  fields.push_back(line.substr(begin));
  return fields;
}

double number(const std::string& field) { return std::strtod(field.c_str(), nullptr); }

Statistics statisticsIn(const std::vector<std::string>& fields) {
  Statistics s;
  s.count = static_cast<int>(number(fields[Column::Runs]));
  s.median = number(fields[Column::Median]);
  s.least = number(fields[Column::Least]);
  s.percentile95 = number(fields[Column::P95]);
  s.low = number(fields[Column::Low]);
  s.high = number(fields[Column::High]);
  return s;
}

}  // namespace

std::vector<KeptCurve> readKeptCurves(const std::filesystem::path& file, const std::string& scene) {
  std::istringstream lines(readFile(file));
  std::vector<KeptCurve> curves;
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> fields = fieldsOf(line);
    if (fields.size() != Column::Failure + 1 || fields[Column::Scene] != scene) continue;
    const std::string key = fields[Column::RowName] + ":" + fields[Column::Library] + ":" + fields[Column::Method];
    if (curves.empty() || curves.back().key != key) curves.push_back({key, {}, {}, {}});
    KeptCurve& curve = curves.back();
    curve.error.push_back(fields[Column::Failure].empty() ? number(fields[Column::Ex])
                                                          : std::numeric_limits<double>::infinity());
    curve.evaluations.push_back(number(fields[Column::Evaluations]));
    curve.seconds.push_back(statisticsIn(fields));
  }
  if (curves.empty()) throw std::runtime_error(fmt::format("{}: no points of the scene {}", file.string(), scene));
  return curves;
}

std::filesystem::path keptPoints(const std::filesystem::path& results) {
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(results)) {
    for (const auto& folder : std::filesystem::directory_iterator(results)) {
      if (std::filesystem::exists(folder.path() / "points.csv")) files.push_back(folder.path() / "points.csv");
    }
  }
  if (files.empty()) throw std::runtime_error(results.string() + ": no results are kept; ./muelle bench --keep");
  return *std::ranges::min_element(files);
}

}  // namespace muelle::bench
