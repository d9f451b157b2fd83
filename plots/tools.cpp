#include "tools.h"

#include "engine/integrators/catalogue.h"

#include <fmt/format.h>
#include <cmath>
#include <cstdlib>

namespace muelle::plots {

std::vector<double> linear(double low, double high, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(low + (high - low) * i / (n - 1));
  return values;
}

std::vector<double> logarithmic(double low, double high, int n) {
  std::vector<double> values = linear(std::log(low), std::log(high), n);
  for (double& value : values) value = std::exp(value);
  return values;
}

std::string asPower(double value) {
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::string plain = fmt::format("{:.0e}", value);  // "3e-09"
  const std::size_t at = plain.find('e');
  if (at == std::string::npos) return plain;  // no number
  std::string text = plain.substr(0, at) + "·10" + (plain[at + 1] == '-' ? "⁻" : "");
  for (const char digit : std::to_string(std::abs(std::stoi(plain.substr(at + 1))))) text += raised[digit - '0'];
  return text;
}

engine::Model oscillator(double m, double k, double x0, double d) {
  engine::Model model;
  model.dimension = 1;
  model.nodes.resize(2);
  model.nodes[0].pinned = true;
  model.nodes[1].x[0] = x0;
  model.nodes[1].m = m;
  model.nodes[1].drag = d;
  model.springs.push_back({.a = 1, .b = 0, .k = k, .L0 = 0.0});
  return model;
}

engine::Model elasticPendulum() {
  engine::Model model;
  model.dimension = 2;
  model.gravity = {0.0, 0.0, -9.81};
  model.nodes.resize(2);
  model.nodes[0].pinned = true;
  model.nodes[1].x = {0.3, 0.0, -1.0};
  model.springs.push_back({.a = 1, .b = 0, .k = 100.0, .L0 = 1.0});
  return model;
}

engine::RunResult run(const engine::ModelSystem& system, std::string_view method, double h, double duration,
                      double outputInterval) {
  engine::RunOptions options;
  options.h = h;
  options.fixedStep = true;
  options.duration = duration;
  options.outputInterval = outputInterval;
  options.checkStability = options.checkNumericalDamping = false;
  return engine::simulate(system, *engine::makeMethod(method), system.initialState(), options);
}

std::vector<double> along(const Trajectory& trajectory, const std::function<double(const State&)>& measure) {
  std::vector<double> values;
  for (std::size_t i = 0; i < trajectory.t.size(); ++i) {
    values.push_back(measure({trajectory.t[i], trajectory.x[i], trajectory.v[i], {}}));
  }
  return values;
}

}  // namespace muelle::plots
