#pragma once
#include "grader/matrix/token.h"

#include <map>
#include <string>
#include <vector>

namespace muelle::grader {

/// A function's definition: its parameters and where its body is.
struct FunctionBody {
  std::map<std::string, std::string> parameters;  ///< name -> type, as "const Vec3 &"
  std::size_t begin = 0;                          ///< index of the token `{`
  std::size_t end = 0;                            ///< index of its `}`
};

/// The definitions of free functions: NAME ( parameters ) { ... }, in namespaces or not. Unnamed parameters are left
/// out; so are functions inside functions (lambdas).
std::vector<FunctionBody> functionBodies(const std::vector<Token>& tokens);

}  // namespace muelle::grader
