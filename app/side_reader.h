#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "app/side_images.h"

namespace enfilade {

/// Reads portal sides' images in a thread of its own, one after another, and frees there what is no
/// longer needed, before it reads on.  All calls but waitForSome() return at once.
class SideReader {
 public:
  /// What was read for a number that was asked for, or why it could not be.
  struct Result {
    std::size_t asked = 0;
    SideImages images;
    std::exception_ptr failure;
  };

  /// `read` is called with the number asked for, in the thread; what it throws goes into the
  /// result.
  explicit SideReader(std::function<SideImages(std::size_t)> read);
  /// Waits for what is being read; the rest is not.
  ~SideReader();
  SideReader(const SideReader&) = delete;
  SideReader& operator=(const SideReader&) = delete;

  void ask(std::size_t number);

  /// No result of `number`, asked for before, is returned from now on until it is asked for again.
  void takeBack(std::size_t number);

  /// Frees `images` in the thread.
  void free(SideImages images);

  /// What has been read since the last call.
  std::vector<Result> results();

  /// The same, but waits until there is something.  Something must have been asked for.
  std::vector<Result> waitForSome();

 private:
  void work();

  std::function<SideImages(std::size_t)> read_;
  std::mutex mutex_;  // of all below; never held while anything is read or freed
  std::condition_variable to_do_, done_;
  std::deque<std::size_t> asked_;
  std::optional<std::size_t> reading_;  // none: nobody waits for what is being read
  std::vector<Result> results_;
  std::vector<SideImages> unneeded_;
  bool stop_ = false;
  std::thread thread_;  // last: it uses the rest
};

}  // namespace enfilade
