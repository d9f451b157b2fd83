#include "lab/hard_cases/cell_text.h"

#include <fmt/format.h>
#include <cmath>
#include <map>

namespace muelle::hard_cases {

std::string errorText(double error) { return std::isfinite(error) ? fmt::format("{:.0e}", error) : "stopped"; }

std::string cellText(const Cell& cell) {
  switch (cell.outcome) {
    case Outcome::Passed:
      return errorText(cell.error);
    case Outcome::FailedAsPredicted:
      return "~" + errorText(cell.error);
    case Outcome::NotApplicable:
      return "n/a";
    case Outcome::FailedUnexpectedly:
      return "!" + errorText(cell.error);
  }
  return "";
}

std::string shortName(const std::string& method) {
  static const std::map<std::string, std::string> names = {{"explicit_euler", "EE"},
                                                           {"symplectic_euler", "SE"},
                                                           {"explicit_midpoint", "EM"},
                                                           {"velocity_verlet", "VV"},
                                                           {"rattle", "RATTLE"},
                                                           {"runge_kutta_4", "RK4"},
                                                           {"dormand_prince_5", "DP5"},
                                                           {"dop853", "DOP853"},
                                                           {"nystrom8", "RKN8"},
                                                           {"nystrom12", "RKN12"},
                                                           {"yoshida4", "Y4"},
                                                           {"kahan_li_8", "KL8"},
                                                           {"rkc2", "RKC2"},
                                                           {"takahashi_imada", "TI"},
                                                           {"backward_euler", "BE"},
                                                           {"bdf2", "BDF2"},
                                                           {"tr_bdf2", "TRB2"},
                                                           {"esdirk4", "ESD4"},
                                                           {"linearised_backward_euler", "LBE"},
                                                           {"implicit_midpoint", "IM"},
                                                           {"discrete_gradient", "DG"},
                                                           {"xpbd", "XPBD"},
                                                           {"projective_dynamics", "PD"}};
  const auto found = names.find(method);
  return found == names.end() ? method : found->second;
}

}  // namespace muelle::hard_cases
