#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace berm {

/// The parts of a request that say who asks. Empty where the header is missing.
struct ViewCaller {
  std::string_view host;
  std::string_view origin;
  std::string_view fetch_site;  ///< Sec-Fetch-Site
};

/// Who may ask.
struct ViewAccess {
  std::string host = "127.0.0.1";  ///< what the server is bound to, as the user wrote it
  bool loopback = true;            ///< nobody but this machine reaches it
};

/// Why a request is refused, none if it is not. A browser sends any page's requests wherever the page likes; the page
/// cannot forge these headers. A Host of another name is a name that was made to point here (DNS rebinding): an address
/// in numbers cannot be, so beyond the loopback any of these will do. `is_api` is stricter: a link elsewhere may lead
/// to the front end, but no page elsewhere may load data.
[[nodiscard]] std::optional<std::string> find_view_refusal(const ViewCaller& caller, const ViewAccess& access,
                                                           bool is_api);

}  // namespace berm
