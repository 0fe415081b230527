#include "berm/core/ordered_parallel.hpp"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace berm {
namespace {

class OrderedParallelTest : public testing::TestWithParam<std::size_t> {};

TEST_P(OrderedParallelTest, HandsOverEveryItemOnceAndInOrder) {
  std::vector<std::size_t> seen;
  OrderedParallel<std::size_t> work(
      500, GetParam(),
      [](std::size_t, std::size_t index, std::size_t& item) {
        if (index % 7 == 0) {
          std::this_thread::sleep_for(std::chrono::microseconds(300));
        }
        item = index * index;
      },
      [&seen](std::size_t index, std::size_t& item) {
        EXPECT_EQ(index, seen.size());
        EXPECT_EQ(item, index * index);
        seen.push_back(item);
        return true;
      });
  work.run();
  EXPECT_EQ(seen.size(), 500U);
}

TEST_P(OrderedParallelTest, KeepsFewItemsInFlight) {
  std::atomic<std::size_t> made{0};
  std::size_t used = 0;
  std::size_t most = 0;
  OrderedParallel<int> work(
      300, GetParam(), [&made](std::size_t, std::size_t, int&) { ++made; },
      [&](std::size_t, int&) {
        std::this_thread::sleep_for(std::chrono::microseconds(50));
        most = std::max(most, made.load() - used);
        ++used;
        return true;
      });
  work.run();
  EXPECT_LE(most, 2 * GetParam());
}

TEST_P(OrderedParallelTest, NoWorkerIsTwoPlacesAtOnce) {
  std::vector<std::atomic<int>> busy(GetParam());
  OrderedParallel<int> work(
      200, GetParam(),
      [&busy](std::size_t worker, std::size_t, int&) {
        EXPECT_EQ(busy.at(worker).fetch_add(1), 0);
        std::this_thread::yield();
        busy.at(worker).fetch_sub(1);
      },
      [](std::size_t, int&) { return true; });
  work.run();
}

TEST_P(OrderedParallelTest, EndsEarlyWhenTold) {
  std::size_t used = 0;
  OrderedParallel<int> work(
      1'000'000, GetParam(), [](std::size_t, std::size_t, int&) {}, [&used](std::size_t, int&) { return ++used < 5; });
  work.run();
  EXPECT_EQ(used, 5U);
}

TEST_P(OrderedParallelTest, TheFirstErrorInOrderComesOut) {
  std::size_t used = 0;
  OrderedParallel<int> work(
      100, GetParam(),
      [](std::size_t, std::size_t index, int&) {
        if (index >= 10) {
          throw std::runtime_error(std::to_string(index));
        }
      },
      [&used](std::size_t, int&) {
        ++used;
        return true;
      });
  try {
    work.run();
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "10");
  }
  EXPECT_EQ(used, 10U);
}

TEST_P(OrderedParallelTest, AnErrorOfTheTakerComesOut) {
  OrderedParallel<int> work(
      100, GetParam(), [](std::size_t, std::size_t, int&) {},
      [](std::size_t index, int&) -> bool {
        if (index == 3) {
          throw std::logic_error("disk full");
        }
        return true;
      });
  EXPECT_THROW(work.run(), std::logic_error);
}

TEST_P(OrderedParallelTest, NothingToDoIsFine) {
  OrderedParallel<int> work(
      0, GetParam(), [](std::size_t, std::size_t, int&) { FAIL(); },
      [](std::size_t, int&) {
        ADD_FAILURE();
        return true;
      });
  work.run();
}

INSTANTIATE_TEST_SUITE_P(Threads, OrderedParallelTest, testing::Values(1, 2, 3, 8));

}  // namespace
}  // namespace berm
