#pragma once
#include "grader/evidence.h"

#include <nlohmann/json_fwd.hpp>

namespace muelle::grader {

/// Evidence as part of a record, short: a class has many of them.
nlohmann::json toJson(const Evidence& evidence);

/// The evidence of toJson(); throws nlohmann::json::exception or std::bad_optional_access for anything else.
Evidence evidenceFromJson(const nlohmann::json& document);

}  // namespace muelle::grader
