#include "course/check/standard_message.h"

#include <array>

namespace muelle {

namespace {

bool has(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// The container whose member asserts; "container" when it is none of the usual ones.
std::string container(std::string_view prettyFunction) {
  // The member's own class stands before its parameters, after the return type; the first name of these is it.
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> names{{{"std::vector<", "std::vector"},
                                                                                {"std::array<", "std::array"},
                                                                                {"std::span<", "std::span"},
                                                                                {"basic_string", "std::string"},
                                                                                {"std::deque<", "std::deque"},
                                                                                {"std::optional<", "std::optional"},
                                                                                {"std::unique_ptr<", "std::unique_ptr"},
                                                                                {"shared_ptr", "std::shared_ptr"}}};
  for (const auto& [part, name] : names) {
    if (has(prettyFunction, part)) return std::string(name);
  }
  return "container";
}

}  // namespace

std::string standardMessage(std::string_view condition, std::string_view prettyFunction) {
  const std::string name = container(prettyFunction);
  if (has(condition, "__n < ") || has(condition, "__pos <")) return "used an index beyond the end of a " + name;
  if (has(condition, "empty()")) return "asked an empty " + name + " for an element";
  if (has(condition, "_M_is_engaged") || has(condition, "nullptr") || has(condition, "pointer()")) {
    return "used a " + name + " that holds nothing";
  }
  return "broke a rule of " + name + ": '" + std::string(condition) + "' does not hold";
}

}  // namespace muelle
