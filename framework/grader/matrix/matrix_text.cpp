#include "grader/matrix/matrix_text.h"

#include "base/text/csv.h"
#include "base/text/lists.h"

#include <fmt/format.h>
#include <algorithm>
#include <iterator>

namespace muelle::grader {

namespace {

constexpr std::size_t nameWidth = 30;
constexpr std::size_t lineWidth = 100;

std::string orNone(const std::set<std::string>& names) { return names.empty() ? "none" : joined(names, ", "); }

std::string shortened(const std::string& text, std::size_t width) {
  return text.size() <= width ? text : text.substr(0, width - 3) + "...";
}

const char* kindText(MatrixRow::Kind kind) {
  switch (kind) {
    case MatrixRow::Kind::Solution:
      return "solution";
    case MatrixRow::Kind::Stub:
      return "stub";
    case MatrixRow::Kind::Right:
      return "right";
    case MatrixRow::Kind::Wrong:
      break;
  }
  return "wrong";
}

/// "solution", "wrong/wrong_sign"
std::string label(const MatrixRow& row) {
  const bool isAlone = row.kind == MatrixRow::Kind::Solution || row.kind == MatrixRow::Kind::Stub;
  return isAlone ? row.name : fmt::format("{}/{}", kindText(row.kind), row.name);
}

/// HookeForce -> HF
std::string capitals(const std::string& suite) {
  std::string code;
  for (const char c : suite) {
    if (c >= 'A' && c <= 'Z' && code.size() < 3) code += c;
  }
  return code.empty() ? suite.substr(0, 1) : code;
}

std::string legend(const Manifest& manifest, const std::vector<std::string>& codes) {
  std::string text;
  std::size_t used = lineWidth;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const std::string entry = fmt::format("{} {}", codes[i], manifest.criteria[i].suite);
    if (used + entry.size() + 3 > lineWidth) {
      text += text.empty() ? "  " : "\n  ";
      used = 2;
    } else {
      text += "   ";
      used += 3;
    }
    text += entry;
    used += entry.size();
  }
  return text + "\n";
}

std::string rowText(const MatrixRow& row, const Manifest& manifest) {
  std::string line = fmt::format("  {:<{}}", shortened(label(row), nameWidth), nameWidth);
  if (!row.trouble.empty()) return line + " " + shortened(row.trouble, lineWidth - nameWidth - 3) + "\n";
  for (const Criterion& criterion : manifest.criteria) {
    const bool lost = row.lost.contains(criterion.suite);
    const bool expected = row.expected.lost.contains(criterion.suite);
    line += fmt::format(" {}{} ", lost ? 'x' : '.', lost == expected ? ' ' : '!');
  }
  if (!row.named.empty()) line += " " + orNone(row.named);
  if (!row.isNamedAsStated()) line += fmt::format("  ! stated: {}", orNone(row.expected.named));
  if (row.expected.noPoints && row.points > 0.0) line += fmt::format("  ! {:g} points", row.points);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

/// What to mend, in the words of the files.
std::string complaint(const MatrixRow& row) {
  if (row.exact()) return "";
  if (!row.trouble.empty()) return fmt::format("  ! {}: {}\n", row.file, row.trouble);
  std::set<std::string> kept;
  std::set<std::string> extra;
  std::set_difference(row.expected.lost.begin(), row.expected.lost.end(), row.lost.begin(), row.lost.end(),
                      std::inserter(kept, kept.end()));
  std::set_difference(row.lost.begin(), row.lost.end(), row.expected.lost.begin(), row.expected.lost.end(),
                      std::inserter(extra, extra.end()));
  std::string text = fmt::format("  ! {}:1:", row.file);
  if (!kept.empty()) text += fmt::format(" passes {} unexpectedly;", orNone(kept));
  if (!extra.empty()) text += fmt::format(" loses {} unexpectedly;", orNone(extra));
  if (!row.isNamedAsStated()) {
    text += fmt::format(" {} named, {} stated;", orNone(row.named), orNone(row.expected.named));
  }
  if (row.expected.noPoints && row.points > 0.0) text += fmt::format(" gets {:g} points;", row.points);
  text.back() = '\n';
  return text;
}

int countOf(const TopicMatrix& matrix, Mutant::Fate fate) {
  return static_cast<int>(std::count_if(matrix.mutants.begin(), matrix.mutants.end(),
                                        [fate](const Mutant& mutant) { return mutant.fate == fate; }));
}

const char* fateText(Mutant::Fate fate) {
  switch (fate) {
    case Mutant::Fate::Killed:
      return "killed";
    case Mutant::Fate::NotCompilable:
      return "not compilable";
    case Mutant::Fate::Survived:
      break;
  }
  return "survived";
}

std::string mutantText(const Mutant& mutant) {
  const Mutation& mutation = mutant.mutation;
  if (!mutant.trouble.empty()) return fmt::format("  ! {}: {}\n", mutation.place(), mutant.trouble);
  if (mutant.asStated() && mutant.reason.empty()) return "";
  std::string text =
      fmt::format("  {} {}  |  {}\n", mutant.asStated() ? "~" : "!", mutation.place(), mutation.lineText);
  if (mutant.asStated()) return text + fmt::format("      {}\n", mutant.reason);
  if (mutant.fate != Mutant::Fate::Survived) {
    return text + fmt::format("      stands in mutants.toml, but is {} now: take it out\n",
                              mutant.fate == Mutant::Fate::Killed ? "killed by " + mutant.killer : "not compilable");
  }
  return text + "      survives without a reason: a test is missing, or it is equivalent and mutants.toml needs\n" +
         survivorEntry(mutation);
}

std::string mutantsText(const TopicMatrix& matrix) {
  if (matrix.mutants.empty()) return "";
  std::string text = fmt::format("\n  {} mutants: {} killed, {} not compilable, {} survived\n", matrix.mutants.size(),
                                 countOf(matrix, Mutant::Fate::Killed), countOf(matrix, Mutant::Fate::NotCompilable),
                                 countOf(matrix, Mutant::Fate::Survived));
  for (const Mutant& mutant : matrix.mutants) text += mutantText(mutant);
  for (const std::string& stale : matrix.staleSurvivors) text += "  ! " + stale + "\n";
  return text;
}

/// What the solution's calls say of the contract and of the listed mistakes.
std::string callsText(const TopicMatrix& matrix) {
  std::string text;
  for (const std::string& end : matrix.endsNotPassed) text += "  ! of the contract's range: " + end + "\n";
  for (const std::string& same : matrix.mistakesNotToldApart) text += "  ! of the listed mistakes: " + same + "\n";
  return text;
}

std::string csvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) line += (line.empty() ? "" : ",") + csvField(field);
  return line + "\n";
}

}  // namespace

std::vector<std::string> columnCodes(const Manifest& manifest) {
  std::vector<std::string> codes;
  for (const Criterion& criterion : manifest.criteria) {
    std::string code = capitals(criterion.suite);
    const std::string stem = code.substr(0, 2);
    for (int i = 2; std::find(codes.begin(), codes.end(), code) != codes.end(); ++i) code = stem + std::to_string(i);
    codes.push_back(code);
  }
  return codes;
}

std::string matrixText(const TopicMatrix& matrix) {
  const Manifest& manifest = matrix.manifest;
  const std::vector<std::string> codes = columnCodes(manifest);
  std::string text = fmt::format("{}: {}\n", manifest.topic, manifest.title) + legend(manifest, codes);
  text += fmt::format("\n  {:<{}}", "", nameWidth);
  for (const std::string& code : codes) text += fmt::format(" {:<3}", code);
  text += " misconception named\n";
  for (const MatrixRow& row : matrix.rows) text += rowText(row, manifest);
  for (const MatrixRow& row : matrix.rows) text += complaint(row);
  return text + mutantsText(matrix) + callsText(matrix);
}

std::string summaryText(const MatrixSummary& sum) {
  const double share = sum.misconceptions > 0 ? 100.0 * sum.named / sum.misconceptions : 100.0;
  std::string text = fmt::format("rows exact                {} of {}\n", sum.exactRows, sum.rows);
  text += fmt::format("false rejections          {}\n", sum.falseRejections);
  text += fmt::format("misconceptions named      {} of {} ({:.0f} %), wrongly named {}\n", sum.named,
                      sum.misconceptions, share, sum.wronglyNamed);
  if (sum.examples > 0) {
    text += fmt::format("calls to check on paper   {} of {} ({:.0f} %)\n", sum.examplesForPaper, sum.examples,
                        100.0 * sum.examplesForPaper / sum.examples);
  }
  const int mutants = sum.killed + sum.notCompilable + sum.survivedWithReason + sum.survivedWithout;
  if (mutants > 0) {
    text += fmt::format("mutants                   {}: killed {}, not compilable {}\n", mutants, sum.killed,
                        sum.notCompilable);
    text += fmt::format("survivors                 with a reason {}, without {}\n", sum.survivedWithReason,
                        sum.survivedWithout);
  }
  if (sum.staleSurvivors > 0) text += fmt::format("entries of mutants.toml to take out  {}\n", sum.staleSurvivors);
  if (sum.troubles > 0) text += fmt::format("faults of the grader      {}: run again\n", sum.troubles);
  return text;
}

std::string matrixCsv(const std::vector<TopicMatrix>& matrices) {
  std::string text = "topic,kind,name,criterion,expected,observed,misconceptions\n";
  for (const TopicMatrix& matrix : matrices) {
    const std::string& topic = matrix.manifest.topic;
    for (const MatrixRow& row : matrix.rows) {
      for (const Criterion& criterion : matrix.manifest.criteria) {
        const std::string observed = row.lost.contains(criterion.suite) ? "lost" : "passed";
        text += csvLine({topic, kindText(row.kind), row.name, criterion.suite,
                         row.expected.lost.contains(criterion.suite) ? "lost" : "passed",
                         row.trouble.empty() ? observed : row.trouble, joined(row.named, " ")});
      }
    }
    for (const Mutant& mutant : matrix.mutants) {
      text += csvLine({topic, "mutant", mutant.mutation.place(), mutant.killer,
                       mutant.reason.empty() ? "killed" : "survived", fateText(mutant.fate), ""});
    }
  }
  return text;
}

}  // namespace muelle::grader
