#pragma once
#include <cstddef>
#include <string>

namespace muelle::grader {

/// libarchive unpacks gzip without comparing checksum and size. Why a gzip file is broken ("its checksum is wrong"), or
/// "". Every member is looked at; zeros may follow the last one, nothing else. Unpacks once more, at most `limit`
/// bytes: what is longer is refused. `bytes` is less than 4 GiB.
std::string gzipFault(const std::string& bytes, std::size_t limit);

}  // namespace muelle::grader
