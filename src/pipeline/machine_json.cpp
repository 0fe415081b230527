#include "machine_json.hpp"

#include <string>
#include <type_traits>

#include <nlohmann/json.hpp>

#include "berm/io/field_access.hpp"

namespace berm {

nlohmann::ordered_json to_json(const Machine& machine) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  Machine::sections([&](std::string_view name, auto member) {
    const auto& config = machine.*member;
    using Config = std::remove_cvref_t<decltype(config)>;
    nlohmann::ordered_json section = nlohmann::ordered_json::object();
    Config::fields(
        EachField{[&](std::string_view key, auto field, auto&&...) { section[std::string(key)] = config.*field; }});
    json[std::string(name)] = std::move(section);
  });
  return json;
}

}  // namespace berm
