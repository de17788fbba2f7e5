#include "batch/sweep.hpp"

#include "batch/sampling.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "jobs/identity.hpp"
#include "jobs/knobs.hpp"
#include "jobs/source.hpp"
#include "scene/commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <thread>

namespace breccia {

namespace {

constexpr std::size_t kMostVariants = 100000;

Varied named(const Settings& section, const Config& scene) {
  Varied varied;
  varied.name = section.text_or("name", section.text("key"));
  varied.key_place = varied.values_place = section.place("key");
  try {
    varied.paths = knob_paths(section.text("key"), scene);
  } catch (const Error& e) {
    throw section.error("key", e.cause(), e.remedy());
  }
  return varied;
}

/// The samples vary slowest, so that more of them leave the others their numbers.
void add_samples(const Settings& batch, const Config& scene, Sweep& sweep) {
  if (!batch.has("sampling")) return;
  const Settings& section = batch.at("sampling");
  Sampling sampling;
  sampling.samples = static_cast<std::size_t>(section.integer("samples"));
  sampling.seed = static_cast<std::uint64_t>(section.integer("seed"));
  sampling.hypercube = section.text("sample_type") == "lhs";
  std::uint32_t key = 0;
  for (const Settings& uncertain : batch.list("uncertain")) {
    Varied varied = named(uncertain, scene);
    const Distribution distribution(uncertain);
    const std::string unit = distribution.unit_text();
    const std::string tail = unit.empty() ? "" : " " + unit;
    for (const double share : sampling.shares(key++)) {
      const double value = distribution.quantile(share);
      varied.values.push_back(number_text(value) + tail);
      varied.words.push_back(fmt::format("{:.4g}{}", value, tail));
    }
    sweep.varied.push_back(std::move(varied));
  }
  sweep.axes.push_back({sampling.samples, 1});
}

void add_values(const Settings& batch, const Config& scene, Sweep& sweep) {
  std::map<std::string, std::size_t> shared;  // axes by their word
  for (const Settings& vary : batch.list("vary")) {
    Varied varied = named(vary, scene);
    varied.values = varied.words = vary.texts("values");
    varied.values_place = vary.place("values");
    varied.axis = sweep.axes.size();
    if (vary.has("together"))
      varied.axis = shared.try_emplace(vary.text("together"), varied.axis).first->second;
    if (varied.axis == sweep.axes.size()) sweep.axes.push_back({varied.values.size(), 1});
    sweep.varied.push_back(std::move(varied));
  }
}

void check_varied(const Sweep& sweep) {
  std::set<std::string> paths, names;
  for (const Varied& varied : sweep.varied) {
    for (const std::string& path : varied.paths)
      if (!paths.insert(path).second)
        throw Error(varied.key_place, "batch: " + path + " is varied twice",
                    "leave one of them out");
    if (!names.insert(varied.name).second)
      throw Error(varied.key_place, "batch: two columns have the name '" + varied.name + "'",
                  "give each its own name");
  }
}

void number_variants(Sweep& sweep, const std::string& place) {
  std::size_t count = 1;
  for (auto axis = sweep.axes.rbegin(); axis != sweep.axes.rend(); ++axis) {
    axis->stride = count;
    count *= axis->length;
    if (count > kMostVariants)
      throw Error(place, fmt::format("batch: more than {} variants", kMostVariants),
                  "vary less, or draw samples at random");
  }
  for (std::size_t i = 0; i < count; ++i) {
    Variant variant;
    variant.number = i;
    variant.folder = fmt::format("{:04}", i);
    for (const Varied& varied : sweep.varied) {
      const std::size_t step = sweep.step(variant, varied.axis);
      for (const std::string& path : varied.paths)
        variant.options.push_back(path + "=" + varied.values[step]);
      variant.label += (variant.label.empty() ? "" : ", ") + varied.name + " " + varied.words[step];
    }
    sweep.variants.push_back(std::move(variant));
  }
}

/// The line of the sweep that a fault of a variant goes back to.
std::string place_of(const Error& fault, const Sweep& sweep, const std::string& otherwise) {
  for (const Varied& varied : sweep.varied) {
    for (const std::string& path : varied.paths) {
      if (fault.cause().rfind(path + ": no such key", 0) == 0) return varied.key_place;
      if (fault.cause().rfind(path + ":", 0) == 0) return varied.values_place;
    }
  }
  return otherwise;
}

/// Resolves a variant, so that nothing that is wrong with it is left for later.
void settle(Variant& variant, const Sweep& sweep, const SceneSource& source, const Schema& schema,
            const std::string& place) {
  try {
    variant.identity = job_identity(schema.resolve(source.read(variant.options)));
  } catch (const Error& e) {
    throw Error(place_of(e, sweep, place),
                "batch: variant " + variant.folder + " (" + variant.label +
                    ") is no right scene: " + e.cause(),
                e.remedy());
  }
}

void read_collect(const Settings& batch, Sweep& sweep) {
  if (!batch.has("collect")) return;
  sweep.collect_place = batch.place("collect");
  for (const std::string& entry : batch.texts("collect")) {
    const auto equals = entry.find('=');
    const bool plain = equals == std::string::npos;
    sweep.collect.push_back(
        {trimmed(entry.substr(0, equals)), trimmed(plain ? entry : entry.substr(equals + 1))});
  }
}

void read_options(const Settings& batch, const BatchRequest& request, Sweep& sweep) {
  sweep.program = request.program;
  sweep.threads =
      request.threads > 0 ? request.threads : static_cast<int>(batch.integer("threads"));
  sweep.ranks = static_cast<int>(batch.integer("ranks"));
  sweep.time_limit = batch.maybe_number("time_limit");
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  sweep.side_by_side =
      request.jobs > 0 ? request.jobs : std::max(1, cores / (sweep.threads * sweep.ranks));
  if (!batch.has("slurm")) return;
  const Settings& slurm = batch.at("slurm");
  sweep.slurm.variants_per_task = static_cast<int>(slurm.integer("variants_per_task"));
  sweep.slurm.partition = slurm.text_or("partition", "");
  if (slurm.has("options")) sweep.slurm.options = slurm.texts("options");
  if (slurm.has("setup")) sweep.slurm.setup = slurm.texts("setup");
}

}  // namespace

Sweep plan_batch(const BatchRequest& request) {
  SceneSource source("batch", request.sweep, request.options);
  Schema schema;
  declare_schema(schema);
  const Settings scene = schema.resolve(source.whole());
  const Settings& batch = scene.at("batch");
  Sweep sweep;
  read_options(batch, request, sweep);
  read_collect(batch, sweep);
  sweep.name = source.name();
  sweep.file = source.file();
  sweep.scene = source.scene();
  sweep.output = request.output ? *request.output : std::filesystem::path(sweep.name + ".batch");
  const Config base = source.read({});
  add_samples(batch, base, sweep);
  add_values(batch, base, sweep);
  check_varied(sweep);
  number_variants(sweep, batch.place());
  const std::vector<std::size_t>& chosen = request.variants;
  for (const std::size_t variant : chosen)
    if (variant >= sweep.variants.size())
      throw Error("--variant",
                  fmt::format("there is no variant {}: the sweep has {}, counted from 0", variant,
                              sweep.variants.size()));
  for (Variant& variant : sweep.variants) {
    if (chosen.empty() || std::find(chosen.begin(), chosen.end(), variant.number) != chosen.end())
      settle(variant, sweep, source, schema, batch.place());
    variant.options.insert(variant.options.begin(), source.shared().begin(), source.shared().end());
  }
  return sweep;
}

}  // namespace breccia
