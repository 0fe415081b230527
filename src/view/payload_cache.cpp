#include "berm/view/payload_cache.hpp"

#include <utility>

namespace berm {

Payload PayloadCache::find(const PayloadKey& key) {
  const std::lock_guard lock(mutex_);
  const auto place = places_.find(key);
  if (place == places_.end()) {
    return nullptr;
  }
  entries_.splice(entries_.begin(), entries_, place->second);
  return place->second->payload;
}

void PayloadCache::keep(const PayloadKey& key, Payload payload) {
  const std::lock_guard lock(mutex_);
  if (const auto place = places_.find(key); place != places_.end()) {
    forget(place->second);
  }
  if (payload->size() > max_bytes_) {
    return;
  }
  while (bytes_ + payload->size() > max_bytes_) {
    forget(std::prev(entries_.end()));
  }
  bytes_ += payload->size();
  entries_.push_front({key, std::move(payload)});
  places_[key] = entries_.begin();
}

std::size_t PayloadCache::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

void PayloadCache::forget(Entries::iterator entry) {
  bytes_ -= entry->payload->size();
  places_.erase(entry->key);
  entries_.erase(entry);
}

}  // namespace berm
