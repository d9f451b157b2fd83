#pragma once
#include <cstddef>
#include <string>

namespace muelle::grader {

/// libarchive unpacks gzip without comparing its checksum. Why a gzip file is broken ("its checksum is wrong"), or "".
/// Unpacks once more, at most `limit` bytes; what is longer, or has several members, passes.
std::string gzipFault(const std::string& bytes, std::size_t limit);

}  // namespace muelle::grader
