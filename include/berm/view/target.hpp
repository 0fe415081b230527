#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace berm {

/// What a request can ask for (docs/view_api.md).
enum class ViewTargetKind : std::uint8_t {
  page,  ///< a file of the front end
  runs,
  scans,
  scan,
  labels,
  trajectory,
  global,
  edges,
  octree,
  map,
  tile,
  piste,
};

struct ViewTarget {
  ViewTargetKind kind = ViewTargetKind::page;
  std::size_t run = 0;
  std::size_t item = 0;  ///< scan or tile
  std::string page;      ///< of kind page: "index.html", "assets/viewer.js"

  friend bool operator==(const ViewTarget&, const ViewTarget&) = default;
};

/// Longer targets are refused; the longest of ours has 40 characters.
inline constexpr std::size_t kMaxTargetLength = 2048;

/// Reads the target of a request. None for what can be no target of ours: anything but letters, digits, '-', '_', '.'
/// and single slashes before the '?', an escape (%2e), a part that begins with a dot, a number that is not written as
/// this program writes it, an unknown name under /api/. Whether the run or the file exists is not said.
[[nodiscard]] std::optional<ViewTarget> parse_view_target(std::string_view target);

}  // namespace berm
