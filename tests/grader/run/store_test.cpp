#include "grader/run/store.h"
#include "base/file.h"

#include <gtest/gtest.h>

#include <chrono>

namespace muelle::grader {
namespace {

class StoreTest : public ::testing::Test {
 protected:
  TemporaryFolder folder_{::testing::TempDir()};
  Store store_{folder_.path()};
};

TEST_F(StoreTest, KeepsWhatIsWritten) {
  EXPECT_FALSE(store_.has("abcd", ".so"));
  EXPECT_EQ(store_.read("abcd", ".so"), std::nullopt);
  store_.write("abcd", ".so", std::string("code\0more", 9));
  EXPECT_TRUE(store_.has("abcd", ".so"));
  EXPECT_FALSE(store_.has("abcd", ".json"));
  EXPECT_EQ(store_.read("abcd", ".so"), std::string("code\0more", 9));
  store_.remove("abcd", ".so");
  EXPECT_FALSE(store_.has("abcd", ".so"));
}

TEST_F(StoreTest, ForgetsFirstWhatWasNotUsedForLongest) {
  const std::string kilobyte(1024, 'x');
  for (const char* key : {"aa1", "bb2", "cc3"}) store_.write(key, "", kilobyte);
  const auto now = std::filesystem::file_time_type::clock::now();
  std::filesystem::last_write_time(store_.file("aa1", ""), now - std::chrono::hours(3));
  std::filesystem::last_write_time(store_.file("bb2", ""), now - std::chrono::hours(2));
  store_.read("aa1", "");  // used now
  EXPECT_EQ(store_.prune(2 * 1024), 1024U);
  EXPECT_TRUE(store_.has("aa1", ""));
  EXPECT_FALSE(store_.has("bb2", ""));
  EXPECT_TRUE(store_.has("cc3", ""));
  EXPECT_EQ(store_.prune(2 * 1024), 0U);
}

TEST_F(StoreTest, WhatCannotBeReadIsNotKept) {
  store_.write("abcd", ".curves", "x");
  std::filesystem::remove(store_.file("abcd", ".curves"));
  std::filesystem::create_symlink("/proc/self/mem", store_.file("abcd", ".curves"));  // opened well, read never
  EXPECT_EQ(store_.read("abcd", ".curves"), std::nullopt);
  store_.write("abcd", ".curves", "y");
  EXPECT_EQ(store_.read("abcd", ".curves"), "y");
}

TEST_F(StoreTest, OfNoFolderIsEmpty) {
  const Store nowhere(folder_.path() / "never" / "made");
  EXPECT_FALSE(nowhere.has("abcd", ""));
  EXPECT_EQ(nowhere.prune(0), 0U);
}

}  // namespace
}  // namespace muelle::grader
