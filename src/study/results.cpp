#include "study/results.hpp"

#include "core/error.hpp"
#include "core/expression.hpp"
#include "jobs/run_results.hpp"
#include "study/ladder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace breccia {

namespace {

constexpr double none = JobResult::kNone;

class Evaluated {
 public:
  explicit Evaluated(const std::filesystem::path& folder)
      : results_(read_results(folder)), quantities_(quantities_of(results_)) {}
  Evaluated(const Evaluated&) = delete;
  Evaluated& operator=(const Evaluated&) = delete;

  [[nodiscard]] double number(const std::string& formula) const {
    return Expression(formula).evaluate(quantities_);
  }
  [[nodiscard]] std::vector<double> series(const std::string& formula) const {
    return Expression(formula).series(quantities_);
  }

  [[nodiscard]] double value(const Judged& judged) const {
    if (judged.against != Judged::Against::curve) return number(judged.value);
    const Curve curve{judged.curve_x == "time" ? quantities_.time : series(judged.curve_x),
                      series(judged.value)};
    return distance(curve, judged.table);
  }

  /// What the value should be; a curve should be at no distance.
  [[nodiscard]] double reference(const Judged& judged) const {
    return judged.against == Judged::Against::value ? number(judged.reference) : 0;
  }

 private:
  Results results_;
  Quantities quantities_;
};

double scale_of(const Judged& judged, const Evaluated& job, double reference) {
  if (!judged.scale.empty()) return std::abs(job.number(judged.scale));
  const double size =
      judged.against == Judged::Against::curve ? size_of(judged.table) : std::abs(reference);
  if (size > 0) return size;
  throw Error("", "the reference is 0, which gives errors no measure", "add a scale");
}

bool all_equal(const std::vector<double>& values) {
  double low = none, high = none;
  int count = 0;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    low = count == 0 ? v : std::min(low, v);
    high = count == 0 ? v : std::max(high, v);
    ++count;
  }
  return count > 1 && high - low <= 1e-12 * std::max(std::abs(low), std::abs(high));
}

std::vector<double> sizes_of(const Study& study, std::size_t knob,
                             const std::vector<std::size_t>& line) {
  std::vector<double> sizes;
  for (const std::size_t j : line)
    sizes.push_back(study.knobs[knob].sizes[static_cast<std::size_t>(study.jobs[j].rung[knob])]);
  return sizes;
}

std::vector<double> picked(const std::vector<double>& values,
                           const std::vector<std::size_t>& line) {
  std::vector<double> some;
  for (const std::size_t j : line) some.push_back(values[j]);
  return some;
}

/// The limit of the ladder that comes nearest to its own, or the value of the largest job.
struct Finest {
  double value = none;
  std::optional<std::size_t> job;  ///< whose value it is; it has no error of its own
  std::string basis = "no job is complete";
};

Finest finest_of(const Study& study, const Runs& runs, const std::vector<double>& value) {
  Finest finest;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < study.knobs.size(); ++k) {
    if (study.knobs[k].sizes.empty()) continue;
    for (const auto& line : lines_along(k, study.jobs)) {
      const auto limit = richardson(sizes_of(study, k, line), picked(value, line));
      if (!limit || std::abs(limit->value - value[line.back()]) >= nearest) continue;
      nearest = std::abs(limit->value - value[line.back()]);
      const std::string others = other_rungs(study.jobs[line.back()], k, study.knobs);
      finest.value = limit->value;
      finest.basis =
          fmt::format("Richardson's estimate {:.6g} along {}{}, order {:.2f}", limit->value,
                      study.knobs[k].name, others.empty() ? "" : " (" + others + ")", limit->order);
    }
  }
  if (std::isfinite(finest.value)) return finest;
  double largest = -1;
  for (std::size_t j = 0; j < value.size(); ++j) {
    if (!std::isfinite(value[j]) || runs.outcomes[j].element_steps() <= largest) continue;
    largest = runs.outcomes[j].element_steps();
    finest = {value[j], j,
              fmt::format("value {:.6g} of the largest job, {}; no ladder converges, so that the "
                          "error of the reference itself is not known",
                          value[j], study.jobs[j].label)};
  }
  return finest;
}

void evaluate(const Study& study, const Judged& judged, const Runs& runs, Findings& f) {
  const std::size_t n = study.jobs.size();
  f.value = f.reference = f.error = std::vector<double>(n, none);
  f.note.resize(n);
  for (std::size_t j = 0; j < n; ++j) {
    if (!runs.outcomes[j].complete) continue;
    try {
      const Evaluated job(study.output / study.jobs[j].folder);
      f.value[j] = job.value(judged);
      if (judged.against == Judged::Against::finest) continue;
      f.reference[j] = job.reference(judged);
      f.error[j] = std::abs(f.value[j] - f.reference[j]) / scale_of(judged, job, f.reference[j]);
    } catch (const Error& e) {
      f.note[j] = e.cause();
    }
  }
}

void hold_against_finest(const Study& study, const Judged& judged, const Runs& runs, Findings& f) {
  const Finest finest = finest_of(study, runs, f.value);
  f.basis = finest.basis;
  for (std::size_t j = 0; j < f.value.size(); ++j) {
    if (!std::isfinite(f.value[j]) || j == finest.job) continue;
    f.reference[j] = finest.value;
    try {
      const Evaluated job(study.output / study.jobs[j].folder);
      f.error[j] = std::abs(f.value[j] - finest.value) / scale_of(judged, job, finest.value);
    } catch (const Error& e) {
      f.note[j] = e.cause();
    }
  }
}

std::vector<Line> lines_of(const Study& study, const std::vector<double>& error) {
  std::vector<Line> lines;
  for (std::size_t k = 0; k < study.knobs.size(); ++k) {
    if (study.knobs[k].sizes.empty()) continue;
    for (const auto& jobs : lines_along(k, study.jobs)) {
      const std::vector<double> sizes = sizes_of(study, k, jobs), errors = picked(error, jobs);
      lines.push_back({k, other_rungs(study.jobs[jobs.front()], k, study.knobs),
                       observed_order(sizes, errors), fitted_order(sizes, errors),
                       errors.back() <= 0.5 * errors.front()});
    }
  }
  return lines;
}

/// The largest error of later rungs on the ladders of a job, where it is above the target: then the
/// job may have reached it by chance.
double relapse(const Study& study, const std::vector<double>& error, const Target& target) {
  double worst = 0;
  for (std::size_t k = 0; k < study.knobs.size(); ++k) {
    if (study.knobs[k].sizes.empty()) continue;
    for (const auto& line : lines_along(k, study.jobs)) {
      auto later = std::find(line.begin(), line.end(), *target.job);
      for (; later != line.end(); ++later)
        if (error[*later] > target.error) worst = std::max(worst, error[*later]);
    }
  }
  return worst;
}

/// Orders where the error falls along a ladder; how many ladders hardly move it.
void say_orders(const Study& study, const Judged& judged, const std::vector<Line>& lines,
                std::vector<std::string>& said) {
  for (std::size_t k = 0; k < study.knobs.size(); ++k) {
    int idle = 0, all = 0;
    const std::string front = judged.name + ", " + study.knobs[k].name;
    for (const Line& line : lines) {
      if (line.knob != k || !std::isfinite(line.fitted)) continue;
      ++all;
      if (!line.moves) {
        ++idle;
        continue;
      }
      said.push_back(fmt::format(
          "{}{}: observed order {:.2f} over the last two rungs, {:.2f} over all.", front,
          line.others.empty() ? "" : " (" + line.others + ")", line.order, line.fitted));
    }
    if (idle > 0)
      said.push_back(
          fmt::format("{}: does not halve the error in {} of {} ladders.", front, idle, all));
  }
}

std::string percent(double share) {
  return fmt::format("{:.3g} %", 100 * share);
}

}  // namespace

double seconds_of(const Study& study, const JobResult& outcome) {
  return median(study.by_processor ? outcome.processor : outcome.wall);
}

void check_names(const Judged& judged, const std::filesystem::path& folder) {
  std::vector<std::string> formulas{judged.value};
  if (judged.against == Judged::Against::value) formulas.push_back(judged.reference);
  if (!judged.scale.empty()) formulas.push_back(judged.scale);
  if (judged.curve_x != "time" && !judged.curve_x.empty()) formulas.push_back(judged.curve_x);
  check_names(formulas, folder);
}

Findings find(const Study& study, const Judged& judged, const Runs& runs) {
  Findings f;
  evaluate(study, judged, runs, f);
  f.basis = judged.against == Judged::Against::curve ? "table" : judged.reference;
  if (judged.against == Judged::Against::finest) hold_against_finest(study, judged, runs, f);
  std::vector<double> seconds;
  for (const JobResult& outcome : runs.outcomes) seconds.push_back(seconds_of(study, outcome));
  f.front = pareto_front(seconds, f.error);
  f.constant = all_equal(f.value);
  f.best = most_accurate(seconds, f.error);
  for (const double target : kTargets)
    f.targets.push_back({target, cheapest(seconds, f.error, target)});
  f.lines = lines_of(study, f.error);
  return f;
}

std::vector<std::string> sentences(const Study& study, const Judged& judged, const Runs& runs,
                                   const Findings& f) {
  std::vector<std::string> said;
  const auto setting = [&](std::size_t j) {
    return fmt::format("{} (error {}, {:.3g} s)", study.jobs[j].label, percent(f.error[j]),
                       seconds_of(study, runs.outcomes[j]));
  };
  for (const Target& target : f.targets) {
    const std::string front = fmt::format("{}, {}: ", judged.name, percent(target.error));
    if (target.job) {
      const double again = relapse(study, f.error, target);
      const std::string chance = again > 0 ? "; a later rung of its ladder has " + percent(again) +
                                                 " again, so chance may have helped"
                                           : "";
      said.push_back(front + "the cheapest setting is " + setting(*target.job) + chance + ".");
    } else {
      said.push_back(front + "none of these reached it" +
                     (f.best ? "; best " + setting(*f.best) : std::string()) + ".");
    }
  }
  say_orders(study, judged, f.lines, said);
  return said;
}

}  // namespace breccia
