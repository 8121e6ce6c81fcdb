#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace enfilade {

/// How much is kept of each of some things, and which of them was used the longest ago: that gives
/// way first.  Time is counted in rounds.
class Recency {
 public:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  explicit Recency(std::size_t things = 0) : entries_(things) {}

  void beginRound() noexcept { ++round_; }
  void use(std::size_t thing) noexcept { entries_[thing].used = round_; }

  /// From now on so much is kept of it; 0: nothing.
  void keep(std::size_t thing, std::size_t bytes) noexcept {
    bytes_ += bytes - entries_[thing].bytes;
    entries_[thing].bytes = bytes;
  }

  bool keeps(std::size_t thing) const noexcept { return entries_[thing].bytes > 0; }
  std::size_t bytes() const noexcept { return bytes_; }  ///< of all of them

  /// Of the things that are kept and were not used in this round, the one used the longest ago; of
  /// several the first; kNone if there is none.
  std::size_t leastRecent() const noexcept {
    std::size_t least = kNone;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Entry& entry = entries_[i];
      if (entry.bytes == 0 || entry.used == round_) continue;
      if (least == kNone || entry.used < entries_[least].used) least = i;
    }
    return least;
  }

 private:
  struct Entry {
    std::size_t bytes = 0;
    std::uint64_t used = 0;  // in which round
  };
  std::vector<Entry> entries_;
  std::size_t bytes_ = 0;
  std::uint64_t round_ = 1;
};

}  // namespace enfilade
