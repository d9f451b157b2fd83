#include "grader/run/pool.h"

#include <thread>
#include <utility>
#include <vector>

namespace muelle::grader {

void Pool::append(Task task) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(task));
  changed_.notify_all();
}

void Pool::prepend(Task task) {
  const std::lock_guard lock(mutex_);
  waiting_.push_front(std::move(task));
  changed_.notify_all();
}

void Pool::addAlone(Task task) {
  const std::lock_guard lock(mutex_);
  alone_.push_back(std::move(task));
  changed_.notify_all();
}

void Pool::run() {
  std::vector<std::thread> threads;
  for (int i = 0; i < threads_; ++i) threads.emplace_back([this] { work(); });
  for (std::thread& thread : threads) thread.join();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Pool::work() {
  while (const Task task = next()) {
    try {
      task();
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    finished();
  }
}

Task Pool::next() {
  std::unique_lock lock(mutex_);
  Task task;
  changed_.wait(lock, [&] {
    if (failure_) return true;
    if (aloneRuns_) return false;
    if (!waiting_.empty()) {
      task = std::move(waiting_.front());
      waiting_.pop_front();
      ++running_;
      return true;
    }
    if (running_ > 0) return false;  // it may add more
    if (alone_.empty()) return true;
    task = std::move(alone_.front());
    alone_.pop_front();
    aloneRuns_ = true;
    ++running_;
    return true;
  });
  return task;
}

void Pool::finished() {
  const std::lock_guard lock(mutex_);
  --running_;
  aloneRuns_ = false;
  changed_.notify_all();
}

}  // namespace muelle::grader
