#include "berm/view/payload_cache.hpp"

#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace berm {
namespace {

Payload of(std::size_t bytes) {
  return std::make_shared<const std::string>(bytes, 'x');
}

PayloadKey key(std::size_t item) {
  return {.kind = 1, .run = 0, .item = item};
}

TEST(PayloadCache, ForgetsWhatWasNotAskedForLongest) {
  PayloadCache cache(100);
  cache.keep(key(1), of(40));
  cache.keep(key(2), of(40));
  EXPECT_TRUE(cache.find(key(1)));
  cache.keep(key(3), of(40));
  EXPECT_TRUE(cache.find(key(1)));
  EXPECT_FALSE(cache.find(key(2)));
  EXPECT_TRUE(cache.find(key(3)));
  EXPECT_EQ(cache.bytes(), 80U);
}

TEST(PayloadCache, StaysWithinItsBoundWhateverComes) {
  PayloadCache cache(1000);
  for (std::size_t i = 0; i < 500; ++i) {
    cache.keep(key(i % 37), of(i * 13 % 700));
    ASSERT_LE(cache.bytes(), 1000U);
  }
  cache.keep(key(99), of(1001));
  EXPECT_FALSE(cache.find(key(99)));
  cache.keep(key(98), of(1000));
  EXPECT_TRUE(cache.find(key(98)));
  EXPECT_EQ(cache.bytes(), 1000U);
}

TEST(PayloadCache, ReplacesAndTellsKeysApart) {
  PayloadCache cache(100);
  cache.keep(key(1), of(30));
  cache.keep(key(1), of(50));
  EXPECT_EQ(cache.bytes(), 50U);
  EXPECT_EQ(cache.find(key(1))->size(), 50U);
  EXPECT_FALSE(cache.find({.kind = 2, .run = 0, .item = 1}));
  EXPECT_FALSE(cache.find({.kind = 1, .run = 1, .item = 1}));
}

TEST(PayloadCache, TakesSeveralThreads) {
  PayloadCache cache(2000);
  std::vector<std::thread> threads;
  for (std::size_t thread = 0; thread < 4; ++thread) {
    threads.emplace_back([&cache, thread] {
      for (std::size_t i = 0; i < 2000; ++i) {
        cache.keep(key((i + thread) % 50), of(100));
        const Payload payload = cache.find(key(i % 50));
        ASSERT_TRUE(!payload || payload->size() == 100);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_LE(cache.bytes(), 2000U);
}

}  // namespace
}  // namespace berm
