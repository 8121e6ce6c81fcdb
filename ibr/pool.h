#pragma once

#include <memory>
#include <mutex>
#include <vector>

namespace enfilade {

/// Things that many tasks use, one at a time each, and give back: as many are made as are in use at
/// once.  Thread-safe.
template <class T>
class Pool {
 public:
  /// A thing taken from a pool, given back at the end.
  class Lease {
   public:
    explicit Lease(Pool& pool) : pool_(pool), thing_(pool.take()) {}
    ~Lease() { pool_.giveBack(thing_); }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    T& operator*() const noexcept { return *thing_; }
    T* operator->() const noexcept { return thing_; }

   private:
    Pool& pool_;
    T* thing_;
  };

 private:
  T* take() {
    const std::lock_guard lock(mutex_);
    if (free_.empty()) {
      all_.push_back(std::make_unique<T>());
      free_.reserve(all_.size());  // so that giving back never allocates
      return all_.back().get();
    }
    T* const thing = free_.back();
    free_.pop_back();
    return thing;
  }
  void giveBack(T* thing) noexcept {
    const std::lock_guard lock(mutex_);
    free_.push_back(thing);
  }

  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> all_;
  std::vector<T*> free_;
};

}  // namespace enfilade
