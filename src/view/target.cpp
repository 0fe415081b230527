#include "berm/view/target.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace berm {
namespace {

constexpr std::size_t kMaxParts = 8;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
}

/// The parts between the slashes; none for an empty or hidden one, or any other character.
std::optional<std::vector<std::string_view>> split(std::string_view path) {
  std::vector<std::string_view> parts;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    const std::string_view part = path.substr(0, end);
    const bool trailing_slash = end + 1 == path.size();
    if (part.empty() || part.front() == '.' || trailing_slash || parts.size() == kMaxParts ||
        !std::all_of(part.begin(), part.end(), is_plain)) {
      return std::nullopt;
    }
    parts.push_back(part);
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return parts;
}

std::optional<std::size_t> parse_index(std::string_view text) {
  constexpr std::size_t kMaxDigits = 9;
  const bool padded = text.size() > 1 && text.front() == '0';
  if (text.empty() || text.size() > kMaxDigits || padded) {
    return std::nullopt;
  }
  std::size_t value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') {
      return std::nullopt;
    }
    value = value * 10 + static_cast<std::size_t>(c - '0');
  }
  return value;
}

struct Layer {
  std::string_view name;
  std::optional<ViewTargetKind> whole;  ///< /api/runs/0/NAME
  std::optional<ViewTargetKind> item;   ///< /api/runs/0/NAME/7
};

constexpr std::array<Layer, 8> kLayers = {{{"scans", ViewTargetKind::scans, ViewTargetKind::scan},
                                           {"labels", ViewTargetKind::labels, {}},
                                           {"trajectory", ViewTargetKind::trajectory, {}},
                                           {"global", ViewTargetKind::global, {}},
                                           {"edges", ViewTargetKind::edges, {}},
                                           {"octree", ViewTargetKind::octree, {}},
                                           {"map", ViewTargetKind::map, ViewTargetKind::tile},
                                           {"piste", {}, ViewTargetKind::piste}}};

/// `parts` are those behind /api/.
std::optional<ViewTarget> parse_api(std::span<const std::string_view> parts) {
  if (parts.empty() || parts[0] != "runs" || parts.size() == 2 || parts.size() > 4) {
    return std::nullopt;
  }
  if (parts.size() == 1) {
    return ViewTarget{.kind = ViewTargetKind::runs};
  }
  const auto run = parse_index(parts[1]);
  const auto* layer = std::find_if(kLayers.begin(), kLayers.end(), [&](const Layer& l) { return l.name == parts[2]; });
  const bool has_item = parts.size() == 4;
  const auto item = has_item ? parse_index(parts[3]) : std::optional<std::size_t>(0);
  if (!run || layer == kLayers.end() || !item) {
    return std::nullopt;
  }
  const auto kind = has_item ? layer->item : layer->whole;
  return kind ? std::optional(ViewTarget{.kind = *kind, .run = *run, .item = *item}) : std::nullopt;
}

}  // namespace

std::optional<ViewTarget> parse_view_target(std::string_view target) {
  if (target.size() > kMaxTargetLength || target.empty() || target.front() != '/') {
    return std::nullopt;
  }
  const std::string_view path = target.substr(1, target.find('?') - 1);
  const auto parts = split(path);
  if (!parts) {
    return std::nullopt;
  }
  if (parts->empty()) {
    return ViewTarget{.page = "index.html"};
  }
  if (parts->front() == "api") {
    return parse_api(std::span(*parts).subspan(1));
  }
  return ViewTarget{.page = std::string(path)};
}

}  // namespace berm
