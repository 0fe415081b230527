#include <string_view>

#include "berm/view/target.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    const std::string_view target(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const auto parsed = berm::parse_view_target(target);
    if (!parsed) {
      return;
    }
    const std::string page = "/" + parsed->page + "/";
    const bool is_page = parsed->kind == berm::ViewTargetKind::page;
    berm::test::demand(!is_page || (page.find("//") == std::string::npos && page.find("/.") == std::string::npos));
    berm::test::demand(page.find_first_of("\\%?#:") == std::string::npos && page.find('\0') == std::string::npos);
    berm::test::demand(parsed->run < 1'000'000'000 && parsed->item < 1'000'000'000);
  });
}
