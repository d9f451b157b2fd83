#include "base/text/nearest.h"
#include "base/text/printable.h"
#include "base/text/words.h"
#include "course/check/diagnostics.h"
#include "course/check/missing_functions.h"

#include <fmt/format.h>
#include <algorithm>

namespace muelle {

namespace {

/// What stands behind `key` in each line that has it, up to a closing quote or the line's end.
std::vector<std::string> subjects(std::string_view linkerText, std::string_view key) {
  std::vector<std::string> found;
  for (std::size_t at = linkerText.find(key); at != std::string_view::npos; at = linkerText.find(key, at + 1)) {
    std::string_view rest = linkerText.substr(at + key.size());
    rest = rest.substr(0, rest.find('\n'));
    if (!rest.empty() && (rest[0] == '`' || rest[0] == '\'')) rest = rest.substr(1, rest.find('\'', 1) - 1);
    const std::string subject(rest);
    if (std::ranges::find(found, subject) == found.end()) found.push_back(subject);
  }
  return found;
}

/// Where a function begins.
struct FunctionStart {
  std::string name;
  int line;               ///< from 1
  std::string_view text;  ///< of the source from that line on
};

/// Functions that begin at the left margin: "type name(": enough to find a misspelt one.
std::vector<FunctionStart> functionsIn(std::string_view text) {
  std::vector<FunctionStart> functions;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view here = text;
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t open = line.find('(');
    if (line.empty() || !isNameCharacter(line[0]) || open == std::string_view::npos) continue;
    std::size_t start = open;
    while (start > 0 && isNameCharacter(line[start - 1])) --start;
    if (start > 0 && start < open) functions.push_back({std::string(line.substr(start, open - start)), number, here});
  }
  return functions;
}

/// The declaration of the function in the contract, on one line; "" when it has none.
std::string declarationIn(std::string_view contract, const std::string& name) {
  for (const FunctionStart& function : functionsIn(contract)) {
    if (function.name != name) continue;
    std::string oneLine;
    for (const char c : function.text.substr(0, function.text.find(';'))) {
      const bool isBlank = c == ' ' || c == '\n' || c == '\t' || c == '\r';
      if (!isBlank) oneLine += c;
      if (isBlank && !oneLine.empty() && oneLine.back() != ' ') oneLine += ' ';
    }
    return oneLine;
  }
  return "";
}

/// "cross" of "Eigen::MatrixBase<...>::cross<...>": Eigen declares everything at once and keeps some of it in headers
/// of its own. "" when the function is not Eigen's.
std::string eigenMember(std::string_view name) {
  int depth = 0;
  std::size_t start = 0;   // after the return type, if there is one
  std::size_t member = 0;  // after the last ::
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name[i] == '<') ++depth;
    if (name[i] == '>') --depth;
    if (depth > 0) continue;
    if (name[i] == ' ') start = i + 1;
    if (name[i] == ' ' || name[i] == ':') member = i + 1;
  }
  if (!name.substr(start).starts_with("Eigen::")) return "";
  const std::string_view rest = name.substr(member);
  return std::string(rest.substr(0, rest.find_first_of("<(")));
}

/// Whether the function is `inline` or `static`.
bool hasSpecifier(const FunctionStart& function, const std::string& specifier) {
  const std::string_view before = function.text.substr(0, function.text.find_first_of("(\n"));
  return before.starts_with(specifier + " ") || contains(before, " " + specifier + " ");
}

/// What keeps a function of the right name from being the contract's: "is inline: nothing outside the file can call it;
/// remove inline".
std::string whyNotTheContracts(const FunctionStart& function) {
  for (const std::string specifier : {"inline", "static"}) {
    if (hasSpecifier(function, specifier)) {
      return fmt::format("is {0}: nothing outside the file can call it; remove {0}", specifier);
    }
  }
  return "has the name, but other argument types (const and & count), static, or a namespace around it";
}

/// What the student has written in the place of a function of the contract: "spring_1d.cpp:12 is inline: ...". "" when
/// there is nothing like it.
std::string insteadOf(const std::string& name, const std::vector<StudentFile>& files, std::string_view contract) {
  for (const StudentFile& file : files) {
    const std::vector<FunctionStart> functions = functionsIn(file.text);
    const auto same = std::ranges::find(functions, name, &FunctionStart::name);
    if (same != functions.end()) return fmt::format("{}:{} {}", file.name, same->line, whyNotTheContracts(*same));
    std::vector<std::string> names;
    for (const FunctionStart& function : functions) {
      // A function that the contract knows is itself, not a misspelling of this one.
      if (declarationIn(contract, function.name).empty()) names.push_back(function.name);
    }
    const std::string guess = nearest(name, names);
    const auto alike = std::ranges::find(functions, guess, &FunctionStart::name);
    if (alike != functions.end())
      return fmt::format("{}:{} is called {}: is that a slip?", file.name, alike->line, guess);
  }
  return "";
}

std::string firstNameOf(const std::vector<StudentFile>& files) {
  return files.empty() ? "the file" : files.front().name;
}

/// A function that is missing, in words.
struct MissingWords {
  std::string what;  ///< lines
  std::string why;   ///< one line without its end: what to mend; "" when nothing tells

  std::string text() const { return what + (why.empty() ? "" : fmt::format("      = {}\n", why)); }
};

MissingWords explainMissing(const std::string& name, const std::vector<StudentFile>& files, std::string_view contract,
                            std::string_view contractName) {
  const std::string declaration = declarationIn(contract, name);
  const std::string fileName = firstNameOf(files);
  if (const std::string member = eigenMember(name); !member.empty()) {
    return {fmt::format("{} uses Eigen's {}(), which stands in another header\n", fileName, member),
            fmt::format("add  #include <Eigen/Dense>  below the include of {}", contractName)};
  }
  if (declaration.empty()) return {fmt::format("{} calls {}, which is written nowhere\n", fileName, name), ""};
  return {fmt::format("{} declares this function, and {} does not define it:\n      {}\n", contractName, fileName,
                      declaration),
          insteadOf(name, files, contract)};
}

/// "springForce" of "muelle::springForce(Eigen::Matrix<...> const&)".
std::string simpleName(std::string_view symbol) {
  if (const std::string member = eigenMember(symbol); !member.empty()) return member;
  const std::string_view name = symbol.substr(0, symbol.find('('));
  const std::size_t last = name.find_last_of(":. ");
  return std::string(last == std::string_view::npos ? name : name.substr(last + 1));
}

}  // namespace

std::vector<std::string> linkedNames(std::string_view linkerText) {
  std::vector<std::string> names;
  for (const std::string_view key :
       {"undefined symbol: ", "undefined reference to ", "multiple definition of ", "duplicate symbol: "}) {
    for (const std::string& subject : subjects(linkerText, key)) {
      // mold: "duplicate symbol: a.o: b.o: main"
      const std::size_t last = subject.rfind(".o: ");
      const std::string name = simpleName(last == std::string::npos ? subject : subject.substr(last + 4));
      if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

std::vector<std::string> missingFunctions(std::string_view linkerText, std::string_view contract) {
  for (const std::string_view key : {"multiple definition of ", "duplicate symbol: "}) {
    if (contains(linkerText, key)) return {};
  }
  const std::vector<std::string> names = linkedNames(linkerText);
  const bool areTheContracts =
      std::ranges::all_of(names, [&](const std::string& name) { return !declarationIn(contract, name).empty(); });
  return areTheContracts ? names : std::vector<std::string>();
}

std::string missingSentence(const std::string& function, const std::vector<StudentFile>& files,
                            std::string_view contract, std::string_view contractName) {
  const std::string why = explainMissing(function, files, contract, contractName).why;
  return printableLine(
      fmt::format("{} is missing: {}", function, why.empty() ? firstNameOf(files) + " does not define it" : why));
}

std::string missingSource(const std::vector<std::string>& functions, const std::vector<StudentFile>& files,
                          std::string_view contract, std::string_view contractName) {
  std::string source =
      fmt::format("#include \"{}\"\n#pragma GCC diagnostic ignored \"-Wunused-parameter\"\n", contractName);
  for (const std::string& function : functions) {
    source += fmt::format("{} {{\n  muelle::eigenAssertionFailed(R\"says({})says\", \"{}\", {{}});\n}}\n",
                          declarationIn(contract, function), missingSentence(function, files, contract, contractName),
                          missingFunction);
  }
  return source;
}

std::vector<std::string> staticFunctions(std::string_view compilerWords, const std::vector<StudentFile>& files) {
  std::vector<std::string> functions;
  for (const Diagnostic& diagnostic : parseDiagnostics(compilerWords, files)) {
    if (!diagnostic.isError) continue;
    const std::size_t end = diagnostic.message.find("' was declared 'extern' and later 'static'");
    if (end == std::string::npos) return {};
    functions.push_back(simpleName(diagnostic.message.substr(0, end)));
  }
  return functions;
}

std::string explainLinkErrors(std::string_view linkerText, const std::vector<StudentFile>& files,
                              std::string_view contract, std::string_view contractName) {
  std::string text;
  for (const std::string_view key : {"multiple definition of ", "duplicate symbol: "}) {
    for (const std::string& subject : subjects(linkerText, key)) {
      const std::size_t last = subject.rfind(": ");
      const std::string name = last == std::string::npos ? subject : subject.substr(last + 2);
      text +=
          name == "main"
              ? "your file defines main: leave it out\n"
              : fmt::format("{} is defined twice: once in your file, once in the checking program; rename it\n", name);
    }
  }
  std::vector<std::string> names;
  for (const std::string_view key : {"undefined symbol: ", "undefined reference to "}) {
    for (const std::string& subject : subjects(linkerText, key)) {
      const std::string name = subject.substr(0, subject.find('('));
      if (std::ranges::find(names, name) == names.end()) names.push_back(name);
    }
  }
  // The first few are enough to mend, as with errors of the compiler.
  constexpr std::size_t most = 3;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i) {
    text += explainMissing(names[i], files, contract, contractName).text();
  }
  if (names.size() > most) text += fmt::format("and {} more that are missing\n", names.size() - most);
  return text.empty() ? printableText(cutText(linkerText, 10, 2000)) : printableText(text);
}

}  // namespace muelle
