#include "harness/demo.h"
#include "catch_the_mistake.h"
#include "wrong_ones.h"

#include <exception>
#include <limits>
#include <memory>

// A table of wrong implementations: which of them your tests catch, and how many questions that takes.

namespace {

/// What a function of the student's came to.
struct Outcome {
  std::string name;
  bool isCaught;
  long questions;
};

using Count = std::shared_ptr<long>;

/// A function that counts how often it is asked.
template <class Result, class... Args>
std::function<Result(Args...)> counted(const Count& count, const std::function<Result(Args...)>& function) {
  return [count, function](Args... args) {
    ++*count;
    return function(args...);
  };
}

/// An exception that leaves the student's function catches nothing.
template <class Verdict>
Outcome outcomeOf(const std::string& name, const Verdict& isTakenForRight) {
  const Count count = std::make_shared<long>(0);
  try {
    const bool isCaught = !isTakenForRight(count);
    return {name, isCaught, *count};
  } catch (const std::exception&) {
    return {name, false, *count};
  }
}

/// \param isTakenForRight verdict on one of them, whose questions are counted
template <class Implementation, class Verdict>
std::vector<Outcome> outcomesOf(const std::vector<Wrong<Implementation>>& all, const Verdict& isTakenForRight) {
  std::vector<Outcome> outcomes;
  for (const Wrong<Implementation>& wrong : all) {
    outcomes.push_back(
        outcomeOf(wrong.name, [&](const Count& count) { return isTakenForRight(count, wrong.implementation); }));
  }
  return outcomes;
}

std::vector<Outcome> forces() {
  return outcomesOf(wrongForces(), [](const Count& count, const SpringForce& given) {
    return submission::isSpringForceRight(counted(count, given));
  });
}

std::vector<Outcome> gradients() {
  return outcomesOf(wrongGradients(), [](const Count& count, const EnergyWithGradient& given) {
    return submission::isGradientRight(counted(count, given.springEnergy), counted(count, given.energyGradient));
  });
}

std::vector<Outcome> dampings() {
  return outcomesOf(wrongDampings(), [](const Count& count, const ProjectedDamping& given) {
    return submission::isDampingRight(counted(count, given));
  });
}

/// Bars that share a name and a colour.
struct Bars {
  std::vector<double> x, y;

  void add(double height, double length) {
    const double gap = std::numeric_limits<double>::quiet_NaN();
    x.insert(x.end(), {0, length, gap});
    y.insert(y.end(), {height, height, gap});
  }
};

/// A bar for each, as long as there are questions, at the height of its name; the first is at the top.
void addBars(muelle::Figure::PanelBuilder panel, const std::vector<Outcome>& outcomes) {
  std::vector<std::string> names;
  Bars caught, takenForRight;
  double longest = 10;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const Outcome& each = outcomes[outcomes.size() - 1 - i];
    const double length = static_cast<double>(each.questions);
    longest = std::max(longest, length);
    names.push_back(each.name);
    (each.isCaught ? caught : takenForRight).add(static_cast<double>(i), length);
  }
  if (!caught.x.empty()) panel.linePoints("caught", caught.x, caught.y).colour(0);
  if (!takenForRight.x.empty()) panel.linePoints("taken for right", takenForRight.x, takenForRight.y).colour(1);
  panel.yNames(names).yRange(-0.6, static_cast<double>(outcomes.size()) - 0.4).xRange(-0.04 * longest, 1.1 * longest);
}

}  // namespace

MUELLE_DEMO {
  muelle::Figure figure("caught", "Wrong implementations: how many questions your tests ask of each",
                        "questions asked");
  figure.slide(1);
  addBars(figure.panel("forces"), forces());
  addBars(figure.panel("energies"), gradients());
  addBars(figure.panel("dampings"), dampings());
  return {figure};
}
