#include "lab/bench/machine.h"

#include "base/file.h"
#include "base/text/fnv1a.h"

#include <fmt/format.h>
#include <sys/utsname.h>
#include <cctype>
#include <chrono>
#include <sstream>
#include <thread>

namespace muelle::bench {

namespace {

std::string processorName() {
  std::istringstream lines(tryReadFile("/proc/cpuinfo").value_or(""));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t begin = line.find(':');
    return begin == std::string::npos ? "unknown processor" : line.substr(begin + 2);
  }
  return "unknown processor";
}

std::string widestInstructionSet() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl")) return "avx512";
  if (__builtin_cpu_supports("avx2")) return "avx2";
  return "sse2";
#elif defined(__aarch64__)
  return "neon";
#else
  return "baseline";
#endif
}

std::string compilerName() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string systemName() {
  utsname names{};
  if (uname(&names) != 0) return "unknown";
  return fmt::format("{} {}", names.sysname, names.release);
}

std::string today() {
  const std::chrono::year_month_day day{std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now())};
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()), static_cast<unsigned>(day.month()),
                     static_cast<unsigned>(day.day()));
}

}  // namespace

std::string Machine::slug() const {
  std::string slug;
  for (const char letter : processor + "_" + instructionSet) {
    const auto c = static_cast<unsigned char>(letter);
    if (std::isalnum(c) != 0) {
      slug.push_back(static_cast<char>(std::tolower(c)));
    } else if (!slug.empty() && slug.back() != '_') {
      slug.push_back('_');
    }
  }
  return slug;
}

Machine thisMachine() {
  Machine machine;
  machine.processor = processorName();
  machine.instructionSet = widestInstructionSet();
  machine.cores = static_cast<int>(std::thread::hardware_concurrency());
  machine.compiler = compilerName();
  machine.flags = MUELLE_BENCH_FLAGS;
  machine.system = systemName();
  machine.date = today();
  return machine;
}

std::string programStamp() {
  return fmt::format("muelle bench {:016x}",
                     fnv1a(tryReadFile("/proc/self/exe").value_or(__DATE__ __TIME__) + processorName()));
}

}  // namespace muelle::bench
