#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "exit_code.hpp"
#include "program.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"
#include "view/http_client.hpp"

namespace berm {
namespace {

using test::Program;
using test::run_berm;

/// The port in what the program printed, once it did.
std::uint16_t wait_for_port(const std::filesystem::path& out) {
  for (int i = 0; i < 3000; ++i) {
    const std::string text = std::filesystem::exists(out) ? test::slurp(out) : std::string();
    if (text.ends_with("/\n")) {
      EXPECT_EQ(text.find("http://127.0.0.1:"), 0U);
      return static_cast<std::uint16_t>(std::stoul(text.substr(std::string("http://127.0.0.1:").size())));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ADD_FAILURE() << "no address was printed";
  return 0;
}

TEST(ViewCommand, ServesARecordingUntilCtrlC) {
  const test::TempFolder folder;
  test::make_recording(folder / "recording", 3);
  for (const int signal : {SIGINT, SIGTERM}) {
    const std::filesystem::path out = folder / ("out" + std::to_string(signal));
    Program program({"view", (folder / "recording").string(), "--no-browser"}, out);
    const std::uint16_t port = wait_for_port(out);
    ASSERT_NE(port, 0);
    EXPECT_EQ(nlohmann::json::parse(test::get(port, "/api/runs").body)[0]["scans"], 3);
    EXPECT_EQ(test::get(port, "/").headers.at("content-type"), "text/html; charset=utf-8");
    const test::HttpClient waiting(port);  // somebody who never asks holds nothing up
    program.send(signal);
    EXPECT_EQ(program.wait().exit_code, app::kWhole);
  }
}

TEST(ViewCommand, SaysWhatItCannotShow) {
  const test::TempFolder folder;
  test::make_recording(folder / "recording", 1);
  const std::string recording = (folder / "recording").string();
  EXPECT_EQ(run_berm({"view", (folder / "nothing").string(), "--no-browser"}).exit_code, app::kFailed);
  EXPECT_EQ(run_berm({"view"}).exit_code, app::kWrongUsage);
  EXPECT_EQ(run_berm({"view", recording, recording, recording}).exit_code, app::kWrongUsage);
  EXPECT_EQ(run_berm({"view", recording, "--host", "nowhere", "--no-browser"}).exit_code, app::kWrongUsage);
  EXPECT_EQ(run_berm({"view", recording, "--port", "70000"}).exit_code, app::kWrongUsage);
}

TEST(ExportCommand, WritesAFileAndReplacesItOnlyWhenTold) {
  const test::TempFolder folder;
  test::make_recording(folder / "recording", 3);
  const std::string recording = (folder / "recording").string();
  const std::string file = (folder / "r.mcap").string();
  const auto result = run_berm({"export", recording, "--to", "foxglove", "-o", file});
  EXPECT_EQ(result.exit_code, app::kWhole) << result.err;
  EXPECT_TRUE(result.out.empty());
  EXPECT_TRUE(std::filesystem::exists(folder / "r.layout.json"));
  EXPECT_EQ(run_berm({"export", recording, "--to", "foxglove", "-o", file}).exit_code, app::kFailed);
  EXPECT_EQ(run_berm({"export", recording, "--to", "foxglove", "-o", file, "--force"}).exit_code, app::kWhole);
}

TEST(ExportCommand, SaysWhatItCannotWrite) {
  const test::TempFolder folder;
  test::make_recording(folder / "recording", 2);
  const std::string recording = (folder / "recording").string();
  const std::string file = (folder / "r.las").string();
  const auto result = run_berm({"export", recording, "--to", "las", "-o", file});
  EXPECT_EQ(result.exit_code, app::kWrongUsage);
  EXPECT_NE(result.err.find("no scan has a pose"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(run_berm({"export", recording, "--to", "laz"}).exit_code, app::kWrongUsage);
  EXPECT_EQ(run_berm({"export", recording}).exit_code, app::kWrongUsage);
}

}  // namespace
}  // namespace berm
