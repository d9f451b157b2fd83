#include "course/check/symbols.h"

#include "base/text/printable.h"
#include "course/check/unneeded_symbols.h"

#include <cxxabi.h>
#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <span>
#include <system_error>
#include <unordered_set>
#include <utility>

namespace muelle {

namespace {

/// A Mac's assembler puts an underscore before every name; a version may stand behind it ("open@GLIBC_2.2.5").
std::string_view plain(std::string_view symbol) {
  symbol = symbol.substr(0, symbol.find('@'));
#ifdef __APPLE__
  if (symbol.starts_with('_')) symbol.remove_prefix(1);
#endif
  return symbol;
}

/// Functions that hand out the memory of the whole program, in a file that defines them: the checking program's, too.
constexpr auto allocators =
    std::to_array<std::string_view>({"malloc", "free", "calloc", "realloc", "reallocarray", "aligned_alloc", "memalign",
                                     "posix_memalign", "valloc", "pvalloc", "malloc_usable_size"});

/// "operator new" of one of its forms that a program may replace, "" of any other symbol: a class's own, or one with
/// arguments of the student's, replaces nothing.
std::string_view replacedOperator(std::string_view symbol) {
  const std::string_view name = symbol.substr(0, std::min<std::size_t>(symbol.size(), 4));
  const bool isNew = name == "_Znw" || name == "_Zna";
  const bool isDelete = name == "_Zdl" || name == "_Zda";
  if (!isNew && !isDelete) return "";
  std::string_view arguments = symbol.substr(name.size());
  const auto drop = [&arguments](std::string_view argument) {
    const bool isThere = arguments.starts_with(argument);
    if (isThere) arguments.remove_prefix(argument.size());
    return isThere;
  };
  if (isDelete && !drop("Pv")) return "";
  const bool hasSize = drop("m") || drop("j");
  if (isNew && !hasSize) return "";
  drop("St11align_val_t");
  drop("RKSt9nothrow_t");
  if (!arguments.empty()) return "";
  return isNew ? "operator new" : "operator delete";
}

/// What of the program's memory the file replaces, as the student writes it; "" when nothing.
std::string_view replacedAllocator(const std::vector<std::string>& defined) {
  // nm sorts by name: delete would come first, and nobody replaces it alone.
  std::string_view released;
  for (const std::string& symbol : defined) {
    const std::string_view name = replacedOperator(symbol);
    if (name == "operator new") return name;
    if (!name.empty()) released = name;
    if (const auto found = std::ranges::find(allocators, symbol); found != allocators.end()) return *found;
  }
  return released;
}

/// Names that others look up in the program that a student's file becomes part of; those of C++ carry their types and
/// begin otherwise.
constexpr auto ofTheCourse = std::to_array<std::string_view>({"muelle"});
constexpr auto ofSanitizers =
    std::to_array<std::string_view>({"__asan_", "__ubsan_", "__lsan_", "__tsan_", "__msan_", "__sanitizer_"});

/// The first symbol that begins with one of the names; "" when none does.
std::string firstOf(const std::vector<std::string>& symbols, std::span<const std::string_view> beginnings) {
  const auto found = std::ranges::find_if(symbols, [beginnings](const std::string& symbol) {
    return std::ranges::any_of(beginnings, [&](std::string_view beginning) { return symbol.starts_with(beginning); });
  });
  return found == symbols.end() ? "" : *found;
}

/// Of initialised, zeroed, constant, common and shared data.
bool isData(char kind) { return std::string_view("BbDdRrCGgSsuVv").find(kind) != std::string_view::npos; }

/// The last of "kind value size", which is hexadecimal; 0 where there is none.
std::size_t sizeIn(std::string_view fields) {
  const std::size_t blank = fields.rfind(' ');
  std::size_t bytes = 0;
  if (blank == std::string_view::npos) return 0;
  const auto [end, error] = std::from_chars(fields.data() + blank + 1, fields.data() + fields.size(), bytes, 16);
  return error == std::errc() ? bytes : 0;
}

/// "lumpedMass(double, int)::table" of its symbol.
std::string readableName(const std::string& symbol) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> name(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status),
                                                         &std::free);
  return status == 0 && name ? name.get() : symbol;
}

/// Of the 1 GiB of address space that a program has in check and in grade, what its static data may take.
constexpr std::size_t mostStaticData = 512UL << 20U;

/// What a table that does not fit is called, and how large it is; "" when all of them fit.
std::string oversize(const std::vector<StaticData>& data) {
  double total = 0;  // the sizes are the submission's: no sum of integers
  for (const StaticData& item : data) total += static_cast<double>(item.bytes);
  if (total <= static_cast<double>(mostStaticData)) return "";
  const StaticData& largest = *std::ranges::max_element(data, {}, &StaticData::bytes);
  return fmt::format("{} takes {} MiB of memory before anything runs; all static variables together may take {}",
                     printableLine(readableName(largest.symbol)), largest.bytes >> 20U, mostStaticData >> 20U);
}

/// Names in the order in which they came first; a file may have a hundred thousand.
class Names {
 public:
  void add(std::string_view name) {
    if (known_.emplace(name).second) names_.emplace_back(name);
  }
  bool contains(const std::string& name) const { return known_.contains(name); }
  std::vector<std::string> take() { return std::move(names_); }
  const std::vector<std::string>& all() const { return names_; }

 private:
  std::unordered_set<std::string> known_;
  std::vector<std::string> names_;
};

}  // namespace

Symbols readSymbols(std::string_view nmText) {
  Symbols symbols;
  Names used;
  Names defined;
  while (!nmText.empty()) {
    const std::size_t end = std::min(nmText.find('\n'), nmText.size());
    const std::string_view line = nmText.substr(0, end);
    nmText.remove_prefix(std::min(end + 1, nmText.size()));
    // "name kind value size"; a line without kind is the name of a file
    const std::size_t blank = line.find(' ');
    if (blank == std::string_view::npos || blank + 1 >= line.size()) continue;
    const std::string_view name = plain(line.substr(0, blank));
    const char kind = line[blank + 1];
    const bool isUndefined = kind == 'U' || kind == 'w' || kind == 'v';
    const bool isGlobal = kind >= 'A' && kind <= 'Z';
    if (isUndefined) used.add(name);
    if (!isUndefined && isGlobal) defined.add(name);
    if (isData(kind)) symbols.data.push_back({std::string(name), sizeIn(line.substr(blank + 1))});
  }
  for (const std::string& name : used.all()) {
    if (!defined.contains(name)) symbols.undefined.push_back(name);
  }
  symbols.defined = defined.take();
  return symbols;
}

std::string symbolRules() {
  std::string rules = unneededSymbols();
  rules += fmt::format("{}\n", mostStaticData);
  for (const std::string_view name : allocators) rules += fmt::format("{}\n", name);
  for (const std::string_view name : ofTheCourse) rules += fmt::format("{}\n", name);
  for (const std::string_view name : ofSanitizers) rules += fmt::format("{}\n", name);
  return rules;
}

SymbolVerdict judgeSymbols(const Symbols& symbols) {
  if (std::ranges::find(symbols.defined, "main") != symbols.defined.end()) {
    return {Outcome::Link, "your file defines main: leave it out"};
  }
  if (const std::string name = firstOf(symbols.defined, ofTheCourse); !name.empty()) {
    return {Outcome::Link, fmt::format("{} is defined in your file: the course has a function of that name", name)};
  }
  if (const std::string name = firstOf(symbols.defined, ofSanitizers); !name.empty()) {
    return {Outcome::Forbidden, fmt::format("it defines {}, which is for the sanitizers to define", name)};
  }
  if (const std::string_view name = replacedAllocator(symbols.defined); !name.empty()) {
    return {Outcome::Forbidden, fmt::format("it replaces {} for the whole program: leave it out", name)};
  }
  if (const std::string what = oversize(symbols.data); !what.empty()) {
    return {Outcome::Crash, "it does not fit into memory: " + what};
  }
  for (const std::string& symbol : symbols.undefined) {
    if (const Unneeded* found = unneeded(symbol)) {
      const std::string_view name = found->shown.empty() ? found->symbol : found->shown;
      return {Outcome::Forbidden, "it " + fmt::format(fmt::runtime(found->sentence), name)};
    }
  }
  return {};
}

}  // namespace muelle
