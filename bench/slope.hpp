#pragma once

namespace berm::bench {

/// Slope of heights over the places where they were taken.
class Slope {
 public:
  void add(double x, double y) {
    n_ += 1.0;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    xy_ += x * y;
  }
  [[nodiscard]] double at(double x) const { return (y_ + value() * (n_ * x - x_)) / n_; }
  [[nodiscard]] double value() const { return (n_ * xy_ - x_ * y_) / (n_ * xx_ - x_ * x_); }

 private:
  double n_ = 0.0;
  double x_ = 0.0;
  double y_ = 0.0;
  double xx_ = 0.0;
  double xy_ = 0.0;
};

}  // namespace berm::bench
