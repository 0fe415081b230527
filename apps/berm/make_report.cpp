#include "make_report.hpp"

#include <string>

#include <spdlog/spdlog.h>

#include "berm/core/error.hpp"
#include "berm/eval/evaluate.hpp"
#include "berm/report/report.hpp"

namespace berm::app {
namespace {

/// Empty without truth.
std::string evaluation_of(const std::filesystem::path& run_folder, const Recording& recording) {
  try {
    const Evaluation evaluation = evaluate(run_folder, recording);
    const LabelEvaluation& labels = evaluation.labels;
    const bool measured = labels.ground || labels.piste || labels.snow || evaluation.trajectory || evaluation.edges;
    return measured || !evaluation.failed.empty() ? to_json(evaluation, run_folder, recording) : "";
  } catch (const Error& error) {
    spdlog::warn("the report does without the truth: {}", error.what());
    return "";
  }
}

}  // namespace

std::filesystem::path make_report(const std::filesystem::path& run_folder, const Recording* recording) {
  return write_report(run_folder, recording == nullptr ? "" : evaluation_of(run_folder, *recording));
}

}  // namespace berm::app
