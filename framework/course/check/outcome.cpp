#include "course/check/outcome.h"

#include <array>
#include <utility>

namespace muelle {

namespace {

constexpr std::array<std::pair<Outcome, std::string_view>, 12> outcomeNames{{
    {Outcome::Passed, "passed"},
    {Outcome::Wrong, "wrong"},
    {Outcome::NeverWritten, "never written"},
    {Outcome::Forbidden, "forbidden"},
    {Outcome::Crash, "crash"},
    {Outcome::Cpu, "processor time"},
    {Outcome::Link, "link"},
    {Outcome::Compile, "compile"},
    {Outcome::Refused, "refused"},
    {Outcome::Killed, "killed"},
    {Outcome::Wall, "wall time"},
    {Outcome::Struck, "struck"},
}};

}  // namespace

std::string_view nameOf(Outcome outcome) {
  for (const auto& [known, name] : outcomeNames) {
    if (known == outcome) return name;
  }
  return "wrong";
}

Outcome outcomeNamed(std::string_view name) {
  for (const auto& [outcome, known] : outcomeNames) {
    if (known == name) return outcome;
  }
  return Outcome::Wrong;
}

}  // namespace muelle
