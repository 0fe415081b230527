#include "progress_bar.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace berm::app {
namespace {

constexpr auto kRedrawEvery = std::chrono::milliseconds(100);
constexpr std::size_t kDefaultColumns = 80;
constexpr std::size_t kMaxBar = 30;

std::size_t terminal_columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kDefaultColumns;
}

std::string time_text(double seconds) {
  const auto whole = static_cast<long long>(std::ceil(seconds));
  if (whole < 60) {
    return fmt::format("{} s", whole);
  }
  if (whole < 3600) {
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  }
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace

std::string progress_text(std::size_t done, std::size_t total, double elapsed_s, std::size_t columns) {
  const double share = total == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(total);
  std::string text = fmt::format("{:3.0f} %  {}/{} scans", std::floor(100.0 * share), done, total);
  if (done > 0 && elapsed_s > 0.0) {
    const double rate = static_cast<double>(done) / elapsed_s;
    text += fmt::format("  {:.1f} scans/s  {} left", rate, time_text(static_cast<double>(total - done) / rate));
  }
  const std::size_t around_bar = 3;
  if (columns > text.size() + around_bar) {
    const std::size_t width = std::min(kMaxBar, columns - text.size() - around_bar);
    const auto filled = static_cast<std::size_t>(share * static_cast<double>(width));
    text = "[" + std::string(filled, '#') + std::string(width - filled, '.') + "] " + text;
  }
  return text.substr(0, columns);
}

ProgressBar::ProgressBar(bool quiet) : active_(!quiet && ::isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (drawn_) {
    std::fputs("\r\033[K", stderr);
  }
}

void ProgressBar::show(std::size_t done, std::size_t total) {
  const Clock::time_point now = Clock::now();
  if (!active_ || (drawn_ && now - last_drawn_ < kRedrawEvery)) {
    return;
  }
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  std::fputs(("\r" + progress_text(done, total, elapsed_s, terminal_columns() - 1) + "\033[K").c_str(), stderr);
  std::fflush(stderr);
  drawn_ = true;
  last_drawn_ = now;
}

}  // namespace berm::app
