#include "piste_runs.hpp"

#include <algorithm>
#include <utility>

namespace berm::bench {
namespace {

constexpr double kShort_s = 3.0;

PisteRun make_run(std::string name, std::string scenario, std::uint64_t seed, std::vector<std::string> settings,
                  std::string flakes = {}) {
  return {.plan = {.name = std::move(name),
                   .scenario = std::move(scenario),
                   .settings = std::move(settings),
                   .seed = seed,
                   .seconds = 10.0},
          .flakes = std::move(flakes)};
}

std::vector<PisteRun> made_runs() {
  const std::string some = "5 %";
  const std::string many = "12 %";
  const std::string storm = "storm";
  return {
      make_run("5 deg", "groomer_clear", 11, {"route.min_gradient_deg=3", "route.max_gradient_deg=7"}),
      make_run("15 deg", "groomer_clear", 12, {"route.min_gradient_deg=12", "route.max_gradient_deg=18"}),
      make_run("25 deg, no heaving", "groomer_clear", 13,
               {"route.min_gradient_deg=22", "route.max_gradient_deg=28", "vehicle.heave_m=0"}),
      make_run("34 deg", "groomer_clear", 14, {"route.min_gradient_deg=30", "route.max_gradient_deg=34"}),
      make_run("downhill", "groomer_clear", 24, {"route.min_gradient_deg=-30", "route.max_gradient_deg=-20"}),
      make_run("cross-fall, heaving", "groomer_clear", 46,
               {"piste.cross_fall_deg=14", "route.min_gradient_deg=15", "vehicle.heave_m=0.06"}),
      make_run("rollers", "groomer_clear", 45, {"route.roller_height_m=1.8", "route.roller_every_m=25"}),
      make_run("bends", "groomer_clear", 15,
               {"route.bend_deg=100", "route.bend_every_m=35", "route.min_radius_m=30", "piste.max_width_m=22"}),
      make_run("forks", "groomer_forks", 16, {"vehicle.turn_on_spot_deg=0"}),
      make_run("narrow, in the forest", "groomer_clear", 17,
               {"piste.min_width_m=8", "piste.max_width_m=12", "things.trees_per_hectare=900", "traffic.oncoming=0"}),
      make_run("fences", "groomer_clear", 18, {"things.fence_share=0.9", "piste.bank_share=0.3"}),
      make_run("no banks", "groomer_clear", 19, {"piste.bank_share=0"}),
      make_run("rough groomed snow", "groomer_clear", 41, {"piste.undulation_m=0.04", "piste.rough_snow_m=0.15"}),
      make_run("5 % flakes", "groomer_snowfall", 20, {}, some),
      make_run("5 % flakes, steep", "groomer_snowfall", 21, {"route.min_gradient_deg=20", "route.max_gradient_deg=34"},
               some),
      make_run("12 % flakes", "groomer_snowfall", 22, {"snowfall.flakes_per_m3=350", "snowfall.gustiness=0.2"}, many),
      make_run(
          "12 % flakes, bends", "groomer_snowfall", 23,
          {"snowfall.flakes_per_m3=350", "snowfall.gustiness=0.2", "route.bend_deg=100", "route.min_gradient_deg=10"},
          many),
      make_run("night storm, drift", "groomer_night_storm", 25, {}, storm),
  };
}

std::vector<PisteRun> runs_on_models(const std::filesystem::path& folder) {
  const auto model = [&folder](const char* name) { return "world.elevation=" + (folder / name).string(); };
  const std::string alone = "traffic.oncoming=0";
  return {
      make_run("model avaPfa, 5 % flakes", "groomer_snowfall", 26, {model("avaPfa.asc"), "route.length_m=60", alone},
               "5 %"),
      make_run("model avaWog", "groomer_clear", 27, {model("avaWog.asc"), "route.length_m=200", alone}),
      make_run("model avaKot", "groomer_clear", 28, {model("avaKot.asc"), "route.length_m=200", alone}),
  };
}

PisteRun find_run(const std::vector<PisteRun>& runs, const std::string& name) {
  return *std::find_if(runs.begin(), runs.end(), [&name](const PisteRun& run) { return run.plan.name == name; });
}

std::vector<PisteRun> short_runs(const std::vector<std::string>& names) {
  const std::vector<PisteRun> all = made_runs();
  std::vector<PisteRun> runs;
  for (const std::string& name : names) {
    runs.push_back(find_run(all, name));
    runs.back().plan.seconds = kShort_s;
  }
  return runs;
}

void add_offset(std::uint64_t offset, std::vector<PisteRun>& runs) {
  for (PisteRun& run : runs) {
    run.plan.seed += offset;
  }
}

}  // namespace

std::vector<PisteRun> piste_runs(const RunChoice& choice) {
  std::vector<PisteRun> runs = choice.quick ? short_runs({"34 deg", "bends", "no banks", "12 % flakes"}) : made_runs();
  if (choice.alpine_dem && !choice.quick) {
    const std::vector<PisteRun> real = runs_on_models(*choice.alpine_dem);
    runs.insert(runs.end(), real.begin(), real.end());
  }
  add_offset(choice.seed_offset, runs);
  return runs;
}

std::vector<PisteRun> runs_with_sensor(const std::string& sensor, std::uint64_t seed_offset) {
  std::vector<PisteRun> runs = short_runs({"15 deg", "bends", "no banks", "12 % flakes"});
  for (PisteRun& run : runs) {
    run.plan.sensor = sensor;
  }
  add_offset(seed_offset, runs);
  return runs;
}

}  // namespace berm::bench
