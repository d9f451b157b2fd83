#pragma once
#include "grader/intake/collector.h"

#include <filesystem>
#include <string>

namespace muelle::grader {

/// Reads an archive (zip, 7z, tar; tar also through one of gzip, bzip2, xz, zstd) in memory and offers its entries to
/// the collector. `bytes` is the whole file; `name`, printable, is for the messages.
/// Throws std::runtime_error, one line, when it is no such archive, broken, encrypted, or unpacks to more than the
/// collector's limit.
void readArchive(const std::string& bytes, const std::string& name, Collector& collector);

}  // namespace muelle::grader
