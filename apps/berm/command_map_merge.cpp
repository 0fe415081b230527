#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "command_map.hpp"
#include "exit_code.hpp"

namespace berm::app {
namespace {

constexpr const char* kMapMergeExamples = R"(Examples:
  berm map merge monday.ot tuesday.ot wednesday.ot -o week.ot
  berm map merge all.ot today/edges.ot -o all.ot --force

The result is the same, byte for byte, in whatever order the maps are named.)";

struct MapMergeCommand {
  std::vector<std::string> maps;
  OutputOption output;
};

std::string quoted_world(const EdgeMap& map) {
  return map.world().empty() ? "no world" : "'" + map.world() + "'";
}

/// Says which files do not fit each other, and why.
void check_fit(const EdgeMap& sum, const std::string& first, const EdgeMap& map, const std::string& file) {
  if (map.config().voxel_m != sum.config().voxel_m) {
    throw FileError(ErrorCode::unsupported, file, std::nullopt,
                    fmt::format("its voxels are {} m, those of {} are {} m: such maps cannot be merged",
                                map.config().voxel_m, first, sum.config().voxel_m));
  }
  if (map.world() != sum.world()) {
    throw FileError(
        ErrorCode::unsupported, file, std::nullopt,
        fmt::format("it names {}, {} names {}: positions in them are not the same, make both with one datum",
                    quoted_world(map), first, quoted_world(sum)));
  }
}

int execute(const MapMergeCommand& command) {
  const std::string& target = command.output.target();
  EdgeMap sum = read_map(command.maps.front());
  for (std::size_t i = 1; i < command.maps.size(); ++i) {
    const EdgeMap map = read_map(command.maps[i]);
    check_fit(sum, command.maps.front(), map, command.maps[i]);
    sum.merge(map);
  }
  write_file_atomically(target, sum.to_octomap());
  return kWhole;
}

}  // namespace

void add_map_merge(CLI::App& app, int& exit_code) {
  constexpr int kLeast = 2;
  constexpr int kMost = 10'000;
  auto command = std::make_shared<MapMergeCommand>();
  CLI::App* sub = app.add_subcommand("merge", "Add maps of one world up");
  sub->footer(kMapMergeExamples);
  sub->add_option("MAP", command->maps, "Maps of road edges (.ot), two or more")
      ->required()
      ->expected(kLeast, kMost)
      ->type_name("FILE");
  command->output.add_options(*sub, "The sum (.ot)");
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
