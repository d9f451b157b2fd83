#pragma once
#include <gtest/gtest.h>

#include <string>

namespace muelle::grader {

/// Says that the running test has seen a mistake of the student's function at work: how often it asks, where its
/// questions lead, what becomes of the energy. It is named, in the words of the manifest, where the criterion is lost.
/// MUELLE_MISTAKE is for mistakes that show in the numbers of every answer; this one for those of a method that is
/// free, whose numbers are nobody's. One a test: the last one counts.
/// \param function of the contract   \param id of the manifest
inline void noteSeen(const std::string& function, const std::string& id) {
  ::testing::Test::RecordProperty("seen", function + " " + id);
}

}  // namespace muelle::grader
