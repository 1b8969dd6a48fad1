// SPDX-License-Identifier: Apache-2.0
// Cost of the facade and the C interface in addition to the computation.  `run_stiffness` minus
// `evaluate_article` is the cost of the facade.  `read_stiffness_json` is the whole path of a
// caller in C; minus `read_and_evaluate_article` it is the cost of the facade with its JSON.
#include <benchmark/benchmark.h>

#include <fstream>
#include <sstream>
#include <string>

#include "strainwave/door/door.hpp"
#include "strainwave/io/gear_reader.hpp"
#include "strainwave/present/json.hpp"
#include "strainwave/strainwave.h"
#include "strainwave/study/evaluate.hpp"

namespace strainwave {
namespace {

const std::string& article_text() {
  static const std::string text = [] {
    std::ostringstream all;
    all << std::ifstream(STRAINWAVE_EXAMPLES "/article.toml").rdbuf();
    return all.str();
  }();
  return text;
}

void evaluate_article(benchmark::State& state) {
  const auto drive = read_drive(article_text(), "article.toml");
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(drive->gear, Method::corrected));
}
BENCHMARK(evaluate_article)->Unit(benchmark::kMicrosecond);

void run_stiffness(benchmark::State& state) {
  const auto drive = read_drive(article_text(), "article.toml");
  const Command& command = command_named(commands(), "stiffness");
  for (auto _ : state) benchmark::DoNotOptimize(run(command, drive, OptionValues(command.options)));
}
BENCHMARK(run_stiffness)->Unit(benchmark::kMicrosecond);

void read_and_evaluate_article(benchmark::State& state) {
  for (auto _ : state) {
    const GearSet gear = read_gear_set(article_text(), "article.toml", {});
    const StiffnessResult result = evaluate(gear, Method::corrected);
    const ResultEvidence evidence = evidence_of(result);
    JsonWriter to;
    const auto part = [&](std::string_view name, const auto& value) {
      if (to.field({.name = name, .unit = {}, .doc = {}})) visit_value(value, {}, to);
    };
    to.begin_record();
    part("verdict", evidence.verdict);
    part("notes", evidence.notes);
    part("equations", evidence.equations);
    part("accuracies", evidence.accuracies);
    part("result", result);
    to.write_numbers(JsonNumbers::as_input);
    part("input", gear);
    to.end_record();
    benchmark::DoNotOptimize(to.document());
  }
}
BENCHMARK(read_and_evaluate_article)->Unit(benchmark::kMicrosecond);

void read_stiffness_json(benchmark::State& state) {
  const sw_text text = {article_text().data(), article_text().size()};
  for (auto _ : state) {
    sw_drive* drive = nullptr;
    sw_answer* answer = nullptr;
    sw_text json{};
    if (sw_read(text, {"article.toml", 12}, nullptr, &drive) != nullptr ||
        sw_run(drive, {"stiffness", 9}, {}, nullptr, 0, nullptr, &answer) != nullptr ||
        sw_answer_document(answer, {"json", 4}, &json) != nullptr)
      state.SkipWithError("the article's drive was refused");
    sw_text_free(json);
    sw_answer_free(answer);
    sw_drive_free(drive);
  }
}
BENCHMARK(read_stiffness_json)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace strainwave
