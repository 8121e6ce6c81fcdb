#include "app/side_reader.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace enfilade {

SideReader::SideReader(std::function<SideImages(std::size_t)> read)
    : read_(std::move(read)), thread_([this] { work(); }) {}

SideReader::~SideReader() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  to_do_.notify_one();
  thread_.join();
}

void SideReader::ask(std::size_t number) {
  {
    const std::lock_guard lock(mutex_);
    asked_.push_back(number);
  }
  to_do_.notify_one();
}

void SideReader::takeBack(std::size_t number) {
  const std::lock_guard lock(mutex_);
  std::erase(asked_, number);
  if (reading_ == number) reading_.reset();
  for (Result& result : results_) {
    if (result.asked == number) unneeded_.push_back(std::move(result.images));
  }
  std::erase_if(results_, [&](const Result& result) { return result.asked == number; });
  to_do_.notify_one();
}

void SideReader::free(SideImages images) {
  {
    const std::lock_guard lock(mutex_);
    unneeded_.push_back(std::move(images));
  }
  to_do_.notify_one();
}

std::vector<SideReader::Result> SideReader::results() {
  const std::lock_guard lock(mutex_);
  return std::exchange(results_, {});
}

std::vector<SideReader::Result> SideReader::waitForSome() {
  std::unique_lock lock(mutex_);
  assert(!asked_.empty() || reading_ || !results_.empty());
  done_.wait(lock, [&] { return !results_.empty(); });
  return std::exchange(results_, {});
}

void SideReader::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    to_do_.wait(lock, [&] { return stop_ || !asked_.empty() || !unneeded_.empty(); });
    if (stop_) return;
    std::vector<SideImages> unneeded = std::exchange(unneeded_, {});
    if (!unneeded.empty()) {
      lock.unlock();
      unneeded.clear();
      lock.lock();
      continue;
    }
    Result result{asked_.front(), {}, nullptr};
    asked_.pop_front();
    reading_ = result.asked;
    lock.unlock();
    try {
      result.images = read_(result.asked);
    } catch (...) {
      result.failure = std::current_exception();
    }
    lock.lock();
    if (reading_) {
      results_.push_back(std::move(result));
      done_.notify_one();
    } else {
      unneeded_.push_back(std::move(result.images));
    }
    reading_.reset();
  }
}

}  // namespace enfilade
