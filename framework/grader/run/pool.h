#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>

namespace muelle::grader {

/// A piece of work; it may add others to the pool that runs it.
using Task = std::function<void()>;

/// Threads that work through tasks. What a task adds comes before what waits already, so that one submission is
/// finished before the next is begun and memory stays bounded by the number of threads.
///
/// Tasks that must run alone (what was killed or ran out of time on a busy machine is tried once more) wait until all
/// others are done, and then run one at a time.
class Pool {
 public:
  explicit Pool(int threads) : threads_(threads) {}
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  /// At the end of what waits: for what the caller of run() has.
  void append(Task task);
  /// Before what waits: for what a running task adds.
  void prepend(Task task);
  /// After everything else, one at a time, with no other task running.
  void addAlone(Task task);

  /// Runs everything. The first exception of a task stops the pool (tasks that run are finished) and is thrown on.
  void run();

 private:
  void work();
  /// The next task to run, waiting for one; nothing when all is done.
  Task next();
  void finished();

  const int threads_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Task> waiting_;
  std::deque<Task> alone_;
  int running_ = 0;
  bool aloneRuns_ = false;
  std::exception_ptr failure_;
};

}  // namespace muelle::grader
