#pragma once
#include <filesystem>
#include <string>

namespace muelle {

/// Builds what the check of one exercise needs besides the parts that all share: its public tests and its demo, where
/// they have not been built yet. The launcher keeps current what there is. One build at a time goes on in a folder,
/// with the launcher's lock. Throws std::runtime_error with the first error when they cannot be built. \param build the
/// build folder; an exercise without build/check/TOPIC.parts is none of its
void buildPublicParts(const std::filesystem::path& build, const std::string& topic);

}  // namespace muelle
