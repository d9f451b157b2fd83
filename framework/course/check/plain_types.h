#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace muelle {

/// A compiler's message with its types under the names of the course: "Eigen::Matrix<double, 3, 1>" is Vec3, a template
/// expression is "Eigen expression", and what stands in {aka ...} goes.
std::string withPlainTypes(std::string_view message);

/// The names of the plain vectors and matrices that a text mentions, each once: {"Vec3", "Vec2"}.
std::vector<std::string> matrixNamesIn(std::string_view text);

}  // namespace muelle
