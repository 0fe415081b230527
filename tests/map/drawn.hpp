#pragma once

#include <rapidcheck.h>

namespace berm::test {

/// For a property: a number of this range, drawn by rapidcheck in a thousand steps.
inline double drawn(double least, double most) {
  return least + (most - least) * *rc::gen::inRange(0, 1001) / 1000.0;
}

}  // namespace berm::test
