#pragma once
#include <sys/types.h>
#include <atomic>
#include <semaphore>
#include <set>
#include <string>
#include <thread>

namespace muelle::grader {

/// A fault of the machine: sends a signal to every descendant of this process that has a name, until it is destroyed.
/// A hit is counted when it told: what was about to end is left out.
class Hunter {
 public:
  /// \param name as the kernel keeps it, at most 15 characters: "cc1plus", "host"
  /// \param most so many hits and no more
  Hunter(std::string name, int signal, int most = 1'000'000);
  Hunter(const Hunter&) = delete;
  Hunter& operator=(const Hunter&) = delete;
  ~Hunter();

  int hits() const { return hits_; }

 private:
  void hunt();

  std::string name_;
  int signal_;
  int most_;
  std::set<pid_t> older_;  ///< processes that were there before
  std::atomic<int> hits_{0};
  std::binary_semaphore end_{0};  ///< free as soon as the hunt is over
  std::thread thread_;
};

}  // namespace muelle::grader
