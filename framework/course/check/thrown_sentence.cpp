#include "course/check/thrown_sentence.h"

#include "base/text/printable.h"

namespace muelle {

std::string thrownSentence(std::string_view text) {
  constexpr std::size_t longest = 480;
  if (text.empty()) return "threw something without a text: no std::exception, or one whose what() says nothing";
  return "threw an exception: " + cut(printableLine(text.substr(0, 16 * longest)), longest);
}

}  // namespace muelle
