#pragma once
/// \file
/// Exercises that lack a file. CMake leaves them out of the build and writes which and why, whenever a file comes or
/// goes.

#include <filesystem>
#include <map>
#include <string>

namespace muelle {

/// The topics that are left out of the build, each with the files that it lacks: "exercises/TOPIC/demo.cpp, ...".
/// \param build the build folder
std::map<std::string, std::string> unfinishedExercises(const std::filesystem::path& build);

/// "exercise TOPIC is left out: it lacks FILE, FILE".
std::string sayUnfinished(const std::string& topic, const std::string& files);

}  // namespace muelle
