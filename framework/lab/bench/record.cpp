#include "lab/bench/record.h"

#include "base/file.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>

namespace muelle::bench {

namespace {

std::vector<std::string> split(std::string_view line) {
  std::vector<std::string> fields(1);
  for (const char letter : line) {
    if (letter == '\t') {
      fields.emplace_back();
    } else {
      fields.back().push_back(letter);
    }
  }
  return fields;
}

std::string lineOf(const std::string& key, const Record::Fields& values) {
  std::string line = key;
  for (const std::string& value : values) line += '\t' + value;
  return line + '\n';
}

}  // namespace

Record::Record(std::filesystem::path file, const std::string& stamp) : file_(std::move(file)) {
  const std::string content = tryReadFile(file_).value_or("");
  std::string_view rest = content;
  std::string kept = stamp + "\n";
  if (content.starts_with(kept)) {
    rest.remove_prefix(kept.size());
    for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
      Fields fields = split(rest.substr(0, end));
      const std::string key = fields.front();
      fields.erase(fields.begin());
      kept += lineOf(key, fields);
      lines_[key] = std::move(fields);
      rest.remove_prefix(end + 1);
    }
  }
  found_ = lines_.size();
  writeFile(file_, kept);  // without a line that was cut off
  out_.open(file_, std::ios::app);
  if (!out_) throw std::runtime_error("cannot write " + file_.string());
}

const Record::Fields* Record::find(const std::string& key) const {
  const auto place = lines_.find(key);
  return place == lines_.end() ? nullptr : &place->second;
}

void Record::add(const std::string& key, Fields values) {
  for (std::string& value : values) {
    std::ranges::replace_if(
        value, [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  }
  out_ << lineOf(key, values) << std::flush;
  if (!out_) throw std::runtime_error("cannot write " + file_.string());
  lines_[key] = std::move(values);
}

}  // namespace muelle::bench
