#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace berm {

/// Makes items 0..count-1 on several threads and hands them over in order on the calling thread. At most
/// `slots` of them exist at a time, whatever `count` is, and each slot's item is used again, memory and all.
///
/// The first exception of `use`, or of `make` in the order of the items, ends the work and comes out of `run`.
template <typename Item>
class OrderedParallel {
 public:
  /// `make(worker, index, item)` fills an item; worker is 0..threads-1.
  using Make = std::function<void(std::size_t, std::size_t, Item&)>;
  /// `use(index, item)` takes it; false ends the work early.
  using Use = std::function<bool(std::size_t, Item&)>;

  OrderedParallel(std::size_t count, std::size_t threads, Make make, Use use)
      : count_(count),
        threads_(threads),
        make_(std::move(make)),
        use_(std::move(use)),
        slots_(threads > 1 ? 2 * threads : 1) {}

  void run() {
    if (threads_ <= 1) {
      run_alone();
      return;
    }
    std::vector<std::jthread> workers;
    workers.reserve(threads_);
    const Ending ending{*this};
    for (std::size_t worker = 0; worker < threads_; ++worker) {
      workers.emplace_back([this, worker] { work(worker); });
    }
    hand_over();
  }

 private:
  struct Slot {
    Item item;
    bool ready = false;
    std::exception_ptr error;
  };

  /// Lets the workers go, on every way out, before their threads are joined.
  struct Ending {
    OrderedParallel& self;
    ~Ending() {
      const std::lock_guard lock(self.mutex_);
      self.ended_ = true;
      self.changed_.notify_all();
    }
  };

  void run_alone() {
    for (std::size_t index = 0; index < count_; ++index) {
      make_(0, index, slots_[0].item);
      if (!use_(index, slots_[0].item)) {
        return;
      }
    }
  }

  void work(std::size_t worker) {
    while (true) {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return ended_ || next_ >= count_ || next_ < used_ + slots_.size(); });
      if (ended_ || next_ >= count_) {
        return;
      }
      const std::size_t index = next_++;
      lock.unlock();
      Slot& slot = slots_[index % slots_.size()];
      std::exception_ptr error;
      try {
        make_(worker, index, slot.item);
      } catch (...) {
        error = std::current_exception();
      }
      lock.lock();
      slot.error = error;
      slot.ready = true;
      changed_.notify_all();
    }
  }

  void hand_over() {
    for (std::size_t index = 0; index < count_; ++index) {
      Slot& slot = slots_[index % slots_.size()];
      {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&slot] { return slot.ready; });
      }
      if (slot.error) {
        std::rethrow_exception(slot.error);
      }
      if (!use_(index, slot.item)) {
        return;
      }
      const std::lock_guard lock(mutex_);
      slot.ready = false;
      ++used_;
      changed_.notify_all();
    }
  }

  std::size_t count_;
  std::size_t threads_;
  Make make_;
  Use use_;
  std::vector<Slot> slots_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t next_ = 0;  ///< first item that nobody makes yet
  std::size_t used_ = 0;  ///< items handed over
  bool ended_ = false;
};

}  // namespace berm
