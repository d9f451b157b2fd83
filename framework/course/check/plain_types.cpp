#include "course/check/plain_types.h"

#include "base/text/words.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <utility>

namespace muelle {

namespace {

/// Position after the bracket that closes the one at `open`; the end of the text when none does.
std::size_t afterClosing(std::string_view text, std::size_t open, char opening, char closing) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == opening) ++depth;
    if (text[i] == closing && --depth == 0) return i + 1;
  }
  return text.size();
}

/// Name of Matrix<arguments>.
std::string matrixName(std::string_view arguments) {
  const std::size_t first = arguments.find(", ");
  const std::size_t second = first == std::string_view::npos ? first : arguments.find(", ", first + 2);
  if (second == std::string_view::npos) return "Eigen matrix";
  const std::string_view scalar = arguments.substr(0, first);
  const std::string_view rows = arguments.substr(first + 2, second - first - 2);
  const std::string_view rest = arguments.substr(second + 2);
  const std::string_view cols = rest.substr(0, rest.find_first_of(",>"));
  if (scalar == "double") {
    static constexpr std::array<std::array<std::string_view, 3>, 8> names{{{"2", "1", "Vec2"},
                                                                           {"3", "1", "Vec3"},
                                                                           {"6", "1", "Vec6"},
                                                                           {"9", "1", "Vec9"},
                                                                           {"-1", "1", "VecX"},
                                                                           {"2", "2", "Mat2"},
                                                                           {"3", "3", "Mat3"},
                                                                           {"-1", "-1", "MatX"}}};
    for (const auto& [r, c, name] : names) {
      if (rows == r && cols == c) return std::string(name);
    }
  }
  const std::string_view suffix = scalar == "double" ? "d" : scalar == "float" ? "f" : scalar == "int" ? "i" : "";
  const bool isFixed = rows != "-1" && cols != "-1" && !suffix.empty();
  if (isFixed && cols == "1") return fmt::format("Eigen::Vector{}{}", rows, suffix);
  if (isFixed && rows == cols) return fmt::format("Eigen::Matrix{}{}", rows, suffix);
  return fmt::format("{} x {} matrix of {}", rows == "-1" ? "n" : rows, cols == "-1" ? "n" : cols, scalar);
}

/// Removes " {aka ...}".
std::string withoutAliases(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t alias = text.find(" {aka ");
    result += text.substr(0, alias);
    if (alias == std::string_view::npos) break;
    text.remove_prefix(afterClosing(text, alias + 1, '{', '}'));
  }
  return result;
}

void replaceAll(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Reads the Eigen type that begins at `start` ("Eigen::..."); gives its plain name and the position behind it.
std::pair<std::string, std::size_t> eigenType(std::string_view text, std::size_t start) {
  std::size_t end = start;
  std::string plain;
  while (end < text.size() && (isNameCharacter(text[end]) || text.substr(end, 2) == "::" || text[end] == '<')) {
    if (text[end] == '<') {
      const std::size_t close = afterClosing(text, end, '<', '>');
      const std::string_view before = text.substr(start, end - start);
      plain = before == "Eigen::Matrix" ? matrixName(text.substr(end + 1, close - end - 2)) : "Eigen expression";
      end = close;
    } else {
      if (text[end] == ':') {
        if (!plain.empty()) plain = "Eigen expression";
        end += 2;
      } else {
        ++end;
      }
    }
  }
  return {plain.empty() ? std::string(text.substr(start, end - start)) : plain, end};
}

}  // namespace

std::string withPlainTypes(std::string_view message) {
  const std::string text = withoutAliases(message);
  std::string result;
  std::size_t at = 0;
  while (at < text.size()) {
    const bool startsWord = at == 0 || (!isNameCharacter(text[at - 1]) && text[at - 1] != ':');
    if (startsWord && text.compare(at, 7, "Eigen::") == 0) {
      const auto [plain, end] = eigenType(text, at);
      result += plain;
      at = end;
    } else {
      result += text[at++];
    }
  }
  for (const auto& [from, to] : {std::pair<std::string_view, std::string_view>{"muelle::", ""},
                                 {"class ", ""},
                                 {"struct ", ""},
                                 {"const Eigen expression", "Eigen expression"},
                                 {"Eigen::Vector2d", "Vec2"},
                                 {"Eigen::Vector3d", "Vec3"},
                                 {"Eigen::VectorXd", "VecX"},
                                 {"Eigen::Matrix3d", "Mat3"},
                                 {"Eigen::MatrixXd", "MatX"},
                                 {"std::__cxx11::basic_string<char>", "std::string"},
                                 {"std::__cxx11::string", "std::string"}}) {
    replaceAll(result, from, to);
  }
  return result;
}

std::vector<std::string> matrixNamesIn(std::string_view text) {
  const std::string_view begin = "Eigen::Matrix<";
  std::vector<std::string> names;
  for (std::size_t at = text.find(begin); at != std::string_view::npos; at = text.find(begin, at + 1)) {
    const std::size_t open = at + begin.size() - 1;
    const std::size_t close = afterClosing(text, open, '<', '>');
    const std::string name = matrixName(text.substr(open + 1, close - open - 2));
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace muelle
