#include "batch/state.hpp"

#include "core/error.hpp"
#include "io/aside_file.hpp"
#include "io/json.hpp"
#include "io/json_reader.hpp"

#include <fmt/format.h>

#include <array>

namespace breccia {

namespace {

namespace fs = std::filesystem;
constexpr const char* kStateFile = "variant.json";
constexpr std::array<const char*, 6> kStages{"not run",  "queued", "running",
                                             "complete", "failed", "stopped"};

/// What variant.json says; null where there is none, or none that can be read.
Json kept(const fs::path& folder) {
  const fs::path file = folder / kStateFile;
  std::error_code trouble;
  if (!fs::exists(file, trouble)) return {};
  try {
    return read_json(file.string());
  } catch (const Error&) {
    return {};  // a damaged file is no result
  }
}

VariantState state_of(const Json& said, const fs::path& folder) {
  VariantState state;
  for (std::size_t i = 0; i < kStages.size(); ++i)
    if (said["stage"].text() == kStages[i]) state.stage = static_cast<VariantState::Stage>(i);
  state.attempts = static_cast<int>(said["attempts"].number());
  state.reason = said["reason"].text();
  state.cut_off = said["cut_off"].flag();
  std::error_code trouble;
  const bool told = fs::exists(folder / "report.json", trouble);
  return state.stage == VariantState::Stage::complete && !told ? VariantState{} : state;
}

}  // namespace

std::string stage_text(VariantState::Stage stage) {
  return kStages[static_cast<std::size_t>(stage)];
}

std::vector<VariantState> load_states(const Sweep& sweep, bool overwrite) {
  std::vector<VariantState> states(sweep.variants.size());
  std::size_t changed = 0, first = 0;
  std::string was;
  for (const Variant& variant : sweep.variants) {
    if (variant.identity.empty()) continue;
    const Json said = kept(sweep.folder(variant.number));
    if (said["identity"].text() == variant.identity) {
      states[variant.number] = state_of(said, sweep.folder(variant.number));
    } else if (!said["identity"].text().empty() && changed++ == 0) {
      first = variant.number;
      was = said["label"].text();
    }
  }
  if (changed == 0 || overwrite) return states;
  const std::string& now = sweep.variants[first].label;
  throw Error(sweep.folder(first).string(),
              was == now
                  ? "holds results of another scene or another build of breccia (" + now + ")"
                  : "holds results of other values (" + was + "; now " + now + ")",
              fmt::format("--overwrite runs the {} variants that have changed anew, --output "
                          "chooses another folder",
                          changed));
}

void save_state(const Sweep& sweep, std::size_t number, const VariantState& state) {
  const Variant& variant = sweep.variants[number];
  fs::create_directories(sweep.folder(number));
  JsonWriter json;
  json.begin_object().member("label", variant.label).member("identity", variant.identity);
  json.member("stage", stage_text(state.stage)).member("attempts", state.attempts);
  json.member("reason", state.reason).member("cut_off", state.cut_off).end_object();
  write_whole((sweep.folder(number) / kStateFile).string(), json.text());
}

}  // namespace breccia
