#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace muelle::grader {

/// A start tag as written.
struct Tag {
  std::string name;
  std::vector<std::string> attributes;  ///< names
};

/// What is wrong with `text` as an XML 1.0 document; "" when nothing. Knows elements, attributes, text, references and
/// the XML declaration; anything else (comments, CDATA, processing instructions) is a fault here.
std::string xmlFault(std::string_view text);

/// The start tags of a page in which every "<" begins a tag and every attribute is quoted.
std::vector<Tag> startTags(std::string_view page);

}  // namespace muelle::grader
