#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

namespace berm {

/// What an answer is made of; shared by the cache and the answers that are on their way.
using Payload = std::shared_ptr<const std::string>;

/// Which answer.
struct PayloadKey {
  std::uint8_t kind = 0;
  std::size_t run = 0;
  std::size_t item = 0;

  friend auto operator<=>(const PayloadKey&, const PayloadKey&) = default;
};

/// Answers that were given lately, bounded in bytes: the one that was not asked for longest goes first. May be used
/// from several threads at once.
class PayloadCache {
 public:
  explicit PayloadCache(std::size_t max_bytes) : max_bytes_(max_bytes) {}

  /// Null if it is not there.
  [[nodiscard]] Payload find(const PayloadKey& key);
  /// Keeps a payload; one larger than the bound is not kept.
  void keep(const PayloadKey& key, Payload payload);
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Entry {
    PayloadKey key;
    Payload payload;
  };
  using Entries = std::list<Entry>;

  void forget(Entries::iterator entry);

  mutable std::mutex mutex_;
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;
  Entries entries_;  ///< the one asked for last comes first
  std::map<PayloadKey, Entries::iterator> places_;
};

}  // namespace berm
