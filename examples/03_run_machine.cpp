// Opens a recording of any layout, takes its scans one by one through the chain that a machine file describes, and
// counts labels. `berm::run` does the same with threads and writes the files of a run.
// usage: 03_run_machine RECORDING MACHINE.yaml

#include <algorithm>
#include <cstdio>

#include "berm/core/error.hpp"
#include "berm/io/recording.hpp"
#include "berm/pipeline/pipeline.hpp"

namespace {

void print_labels(const berm::Recording& recording, const berm::Machine& machine) {
  berm::Pipeline pipeline(machine);
  berm::Scan scan;  // reused: memory does not grow with the recording
  scan.T_base_sensor = machine.mount.T_base_sensor();
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.read(i, scan);
    const auto labels = pipeline.process(scan).labels;
    const auto count = [&](berm::Label label) { return std::count(labels.begin(), labels.end(), label); };
    std::printf("scan %zu at %.3f s: %zu points, %td drivable, %td obstacle\n", i, berm::to_seconds(scan.stamp_ns),
                scan.cloud.size(), count(berm::Label::drivable), count(berm::Label::obstacle));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: %s RECORDING MACHINE.yaml\n", argv[0]);
    return 2;
  }
  try {
    const berm::Recording recording = berm::Recording::open(argv[1]);
    print_labels(recording, berm::read_machine(argv[2]));
  } catch (const berm::Error& error) {
    // Says which file, where in it, and what was expected there.
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
