#pragma once
#include <string>
#include <string_view>

namespace muelle {

/// The noun that goes with a number: "node" of 1, "nodes" of 0, 2, 3 ... `several` where an s at the end does not do.
std::string nounFor(long long count, std::string_view one, std::string_view several = {});

/// A number with its noun: "1 node", "1200 nodes".
std::string counted(long long count, std::string_view one, std::string_view several = {});

/// The same with the digits in groups: "1,200 nodes".
std::string countedInGroups(long long count, std::string_view one, std::string_view several = {});

/// "1,234,567".
std::string grouped(long long count);

}  // namespace muelle
