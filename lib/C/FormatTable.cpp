// Tables of formats in C.
#include "voxc/Measure/FormatTable.h"
#include "C/BuildOptions.h"
#include "C/CallersInput.h"

using namespace voxc;
using namespace voxc::c;

struct voxc_format_table {
  explicit voxc_format_table(FormatTable found) : table(std::move(found)) {
    for (const FormatRow &row : table.rows) {
      std::string &text = passes.emplace_back();
      for (const std::string &pass : row.passes)
        text += (text.empty() ? "" : ",") + pass;
    }
  }

  FormatTable table;
  std::vector<std::string> passes; ///< Of each row, with commas between.
};

namespace {

FormatQuestion questionOf(const voxc_choice_options &options, const char *device) {
  const auto *rays = reinterpret_cast<const Ray *>(options.rays);
  FormatQuestion question{.objective = textOr(options.objective, "balanced"),
                          .maxBytes = options.max_bytes,
                          .device = textOr(options.device, device),
                          .precision = textOr(options.precision, "exact"),
                          .formats = {options.formats, options.formats + options.format_count},
                          .rays = {rays, rays + options.ray_count},
                          .editable = options.editable != 0,
                          .threads = options.threads};
  if (options.seconds != 0)
    question.seconds = options.seconds;
  return question;
}

using Answer = Expected<FormatTable>(const SourceOpener &open, const FormatQuestion &question,
                                     const Progress &progress);

/// Asks a question about an input; `device` is what stands for none.
voxc_error *ask(Answer &answer, const char *device, const char *input,
                const voxc_input_options *input_options, const voxc_choice_options *options,
                voxc_format_table **table) {
  return guarded([&]() -> Expected<void> {
    const auto given = VOXC_TRY(optionsOf(options));
    const CallersProgress progress(given.progress);
    auto asked = VOXC_TRY(CallersInput::of(input, VOXC_TRY(optionsOf(input_options))));
    fillResolution(asked.arguments(), asked.name());
    FormatQuestion question = questionOf(given, device);
    question.memory = memoryOf({.memory_bytes = given.memory_bytes});
    question.name = asked.name();
    const auto open = [&]() -> Expected<std::unique_ptr<VoxelSource>> {
      constexpr int kMost = 1 << kMaxLog2Extent;
      auto opened =
          VOXC_TRY(asked.open({kMost, kMost, kMost}, given.threads, question.memory, progress.get()));
      return std::move(opened.source);
    };
    auto answered = VOXC_TRY(answer(open, question, progress.get()));
    *table = new voxc_format_table(std::move(answered));
    return {};
  });
}

} // namespace

voxc_error *voxc_suggest(const char *input, const voxc_input_options *input_options,
                         const voxc_choice_options *options, voxc_format_table **table) {
  return ask(suggestFormats, "cpu", input, input_options, options, table);
}

voxc_error *voxc_search(const char *input, const voxc_input_options *input_options,
                        const voxc_choice_options *options, voxc_format_table **table) {
  return ask(searchFormats, "", input, input_options, options, table);
}

void voxc_format_table_free(voxc_format_table *table) { delete table; }

size_t voxc_format_table_rows(const voxc_format_table *table) { return table->table.rows.size(); }

uint64_t voxc_format_table_voxels(const voxc_format_table *table) { return table->table.voxels; }

size_t voxc_format_table_sets(const voxc_format_table *table) { return table->table.sets.size(); }

const char *voxc_format_table_set(const voxc_format_table *table, size_t set) {
  return table->table.sets[set].c_str();
}

void voxc_format_table_row(const voxc_format_table *table, size_t row, voxc_format_row *values) {
  const FormatRow &found = table->table.rows[row];
  *values = {.format = found.format.c_str(),
             .passes = table->passes[row].c_str(),
             .bytes = found.bytes,
             .exact = found.isExact,
             .frontier = found.isOnFrontier,
             .chosen = found.isChosen,
             .failure = found.failure.empty() ? nullptr : found.failure.c_str()};
}

void voxc_format_table_speed(const voxc_format_table *table, size_t row, size_t set,
                             voxc_format_speed *speed) {
  const std::vector<FormatSpeed> &speeds = table->table.rows[row].speeds;
  const FormatSpeed found = set < speeds.size() ? speeds[set] : FormatSpeed();
  *speed = {found.predicted,   found.measured,  found.slowest, found.fastest,
            found.checkedRays, found.wrongRays, found.maxUlp};
}
