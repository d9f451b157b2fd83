#include "grader/testing/listed_mistakes.h"

namespace muelle::grader {

namespace {

using Numbers = CallHistoryBase::Numbers;

/// All mistakes begin in one group, the oracle's; each call parts those that give other numbers than the first of
/// their group.
class Parting {
 public:
  explicit Parting(const CallHistoryBase& history) : history_(history) {
    for (const std::string& id : history.mistakes()) mistakes_.push_back({id, 0});
  }

  std::vector<ListedMistake> run() {
    for (std::size_t call = 0; call < history_.calls(); ++call) part(call);
    return std::move(mistakes_);
  }

 private:
  /// A group that a call has made, out of which other, and the numbers that its members give.
  struct Made {
    int from;
    int group;
    Numbers numbers;
  };

  void part(std::size_t call) {
    std::map<int, Numbers> ofGroup{{0, history_.oracle(call)}};
    std::vector<Made> made;
    for (std::size_t i = 0; i < mistakes_.size(); ++i) {
      const int group = mistakes_[i].group;
      Numbers numbers = history_.listed(i, call);
      const Numbers& first = ofGroup.try_emplace(group, numbers).first->second;
      if (!agree(numbers, first, history_.roundOff(call))) mistakes_[i].group = otherGroup(made, group, numbers, call);
    }
  }

  int otherGroup(std::vector<Made>& made, int from, Numbers& numbers, std::size_t call) {
    for (const Made& each : made) {
      if (each.from == from && agree(numbers, each.numbers, history_.roundOff(call))) return each.group;
    }
    made.push_back({from, ++groups_, std::move(numbers)});
    return groups_;
  }

  const CallHistoryBase& history_;
  std::vector<ListedMistake> mistakes_;
  int groups_ = 0;
};

}  // namespace

std::vector<ListedMistake> listedMistakes(const CallHistoryBase& history) {
  if (!history.hasOracle()) return {};
  return Parting(history).run();
}

}  // namespace muelle::grader
