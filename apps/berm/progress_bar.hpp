#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace berm::app {

/// One line on stderr that shows share, rate and time left while work lasts, and is wiped afterwards. Nothing at all if
/// stderr is no terminal.
class ProgressBar {
 public:
  explicit ProgressBar(bool quiet);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::size_t done, std::size_t total);

 private:
  using Clock = std::chrono::steady_clock;

  bool active_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_drawn_;
};

/// The text of the line, at most `columns` wide: "[####......]  40 %  6/15 scans  12.5 scans/s  1 s left".
[[nodiscard]] std::string progress_text(std::size_t done, std::size_t total, double elapsed_s, std::size_t columns);

}  // namespace berm::app
