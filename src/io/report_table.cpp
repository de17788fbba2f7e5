#include "io/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <ostream>

namespace breccia {
namespace {

[[gnu::format(printf, 1, 2)]] std::string form(const char* format, ...) {
  std::array<char, 512> buffer;
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(buffer.data(), buffer.size(), format, values);
  va_end(values);
  return buffer.data();
}

// A number with a prefix of thousands ("1.23 M"); `base` is 1000 for counts, 1024 for bytes.
std::string scaled(double value, double base) {
  const char* prefix[] = {"", " k", " M", " G", " T"};
  std::size_t k = 0;
  while (std::abs(value) >= base && k + 1 < std::size(prefix)) {
    value /= base;
    ++k;
  }
  return form(k == 0 ? "%.0f%s" : "%.3g%s", value, prefix[k]);
}

std::string bytes_text(std::int64_t bytes) {
  const std::string text = scaled(static_cast<double>(bytes), 1024);
  return bytes < 1024 ? text + " B" : text + "iB";
}

std::string number_or_dash(double value) {
  return std::isfinite(value) ? form("%.5g", value) : "-";
}

void heading(std::ostream& out, const char* title) {
  out << "\n" << title << "\n";
}

void print_run(const Report& r, std::ostream& out) {
  out << r.title << "\n"
      << form("%.*s", static_cast<int>(std::min<std::size_t>(r.title.size(), 78)),
              "------------------------------------------------------------------------------")
      << "\n";
  out << "  status      " << r.status << (r.reason.empty() ? "" : ": " + r.reason) << "\n";
  out << form("  simulated   %.6g s in %lld steps", r.time, static_cast<long long>(r.steps))
      << form(", %.3g s on the clock\n", r.wall_seconds);
  out << "  step        " << number_or_dash(r.time_step.min) << " s least, "
      << number_or_dash(r.time_step.mean) << " s mean"
      << (r.time_step.set_by.empty() ? "" : ", set by " + r.time_step.set_by) << "\n";
  if (r.time_step.added_mass > 0)
    out << form("  added mass  %.3g %%\n", 100 * r.time_step.added_mass);
  out << form("  mesh        %lld elements, %lld nodes\n", static_cast<long long>(r.elements),
              static_cast<long long>(r.nodes));
  const Report::Interfaces& i = r.interfaces;
  if (i.bonded + i.inserted + i.released > 0) {
    out << form("  interfaces  %lld bonded, %lld inserted, %lld released; ",
                static_cast<long long>(i.bonded), static_cast<long long>(i.inserted),
                static_cast<long long>(i.released))
        << r.fragments << (r.fragments == 1 ? " fragment\n" : " fragments\n");
  }
  if (r.rest.wanted)
    out << (r.rest.reached ? form("  rest        at %.6g s", r.rest.time)
                           : std::string("  rest        not reached"))
        << form("; largest net force %.2g of the mean on a corner\n", r.rest.unbalance);
  out << "  machine     " << r.backend
      << form(", %d thread%s", r.threads, r.threads == 1 ? "" : "s")
      << form(", %d rank%s, ", r.ranks, r.ranks == 1 ? "" : "s") << r.precision << " precision\n";
  out << "  speed       " << scaled(r.element_steps_per_second, 1000)
      << " element-steps/s, peak memory " << bytes_text(r.peak_memory_bytes) << "\n";
  out << "  version     " << r.version.release << " " << r.version.commit << ", " << r.version.build
      << "\n";
  if (!r.state_hash.empty()) out << "  state hash  " << r.state_hash << "\n";
}

void print_costs(const Report& r, std::ostream& out) {
  if (r.effects.empty()) return;
  double rest = r.wall_seconds;
  heading(out, "Cost");
  out << form("  %-28s %10s %7s %12s %12s\n", "effect", "seconds", "share", "memory", "launches");
  const auto share_of = [&r](double seconds) {
    return r.wall_seconds > 0 ? 100 * seconds / r.wall_seconds : 0;
  };
  for (const Report::Effect& effect : r.effects) {
    rest -= effect.seconds;
    out << form("  %-28s %10.3f %6.1f%% %12s %12s\n", effect.name.c_str(), effect.seconds,
                share_of(effect.seconds), bytes_text(effect.bytes).c_str(),
                scaled(static_cast<double>(effect.launches), 1000).c_str());
  }
  out << form("  %-28s %10.3f %6.1f%%\n", "everything else", rest, share_of(rest));
  if (r.effects_off.empty()) return;
  out << "  off:";
  for (const std::string& name : r.effects_off) out << " " << name;
  out << "\n";
}

void print_ledger(const Report& r, std::ostream& out) {
  if (r.ledger.empty()) return;
  double largest = 0;
  for (const auto& [name, energy] : r.ledger) largest = std::max(largest, std::abs(energy));
  heading(out, "Energy [J]");
  for (const auto& [name, energy] : r.ledger) {
    if (energy == 0) continue;
    const auto bar =
        largest > 0 ? static_cast<std::size_t>(std::lround(30 * std::abs(energy) / largest)) : 0u;
    const std::string shown =
        form("  %-16s %14.6g  ", name.c_str(), energy) + std::string(bar, '=');
    out << shown.substr(0, shown.find_last_not_of(' ') + 1) << "\n";
  }
  if (r.guard.looks > 0)
    out << form(
        "  guard            %.2g %% came from nowhere at most, bodies overlapped by %.2g "
        "heights of an element\n",
        100 * r.guard.made, r.guard.overlap);
  out << "  residuals        level 1 " << number_or_dash(r.res_1) << " (alarm 1e-10), level 2 "
      << number_or_dash(r.res_2) << " (alarm 0.01)\n";
}

void print_checks(const Report& r, std::ostream& out) {
  if (r.checks.empty()) return;
  heading(out, "Checks");
  for (const Report::Check& check : r.checks) {
    const std::string unit = check.unit.empty() || check.unit == "1" ? "" : " " + check.unit;
    const std::string tolerance = check.relative ? form("%.4g %%", 100 * check.tolerance)
                                                 : form("%.4g", check.tolerance) + unit;
    out << (check.pass ? "  pass  " : "  FAIL  ") << form("%-32s ", check.name.c_str())
        << number_or_dash(check.value) << unit << "  (reference " << number_or_dash(check.reference)
        << unit << ", tolerance " << tolerance << ")"
        << (check.note.empty() ? "" : "  " + check.note) << "\n";
  }
}

}  // namespace

void print_report(const Report& report, std::ostream& out) {
  print_run(report, out);
  print_costs(report, out);
  print_ledger(report, out);
  print_checks(report, out);
}

}  // namespace breccia
