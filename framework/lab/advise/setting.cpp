#include "lab/advise/setting.h"

#include "engine/integrators/catalogue.h"

#include <fmt/format.h>

namespace muelle::lab {

std::string Setting::name() const {
  return fixed && engine::methodInfo(method).adaptive ? method + ", fixed step" : method;
}

std::string Setting::valueText() const {
  return fixed ? fmt::format("h = {:.3g} s", value) : fmt::format("tolerance {:.2g}", value);
}

engine::Scene withSetting(engine::Scene scene, const Setting& setting) {
  scene.method = setting.method;
  scene.step.reset();
  scene.tolerance.reset();
  (setting.fixed ? scene.step : scene.tolerance) = setting.value;
  return scene;
}

}  // namespace muelle::lab
