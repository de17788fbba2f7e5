#include "step/ledger.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

namespace breccia {

namespace {
double ratio(double residual, double scale) {
  return scale > 0 ? residual / scale : 0.0;
}
}  // namespace

void Ledger::add(const std::string& name, EnergyKind kind, double joule) {
  for (Entry& entry : entries_)
    if (entry.name == name) {
      entry.joule += joule;
      return;
    }
  entries_.push_back({name, kind, joule});
}

namespace {

/// Entries as text, so that ranks may have different ones.
std::string names_of(const std::vector<Ledger::Entry>& entries) {
  std::string text;
  for (const Ledger::Entry& entry : entries)
    text += (entry.kind == EnergyKind::stored ? 's' : 'd') + entry.name + '\n';
  return text;
}

}  // namespace

void Ledger::merge(const World& world) {
  if (world.size() == 1) return;
  const std::string mine = names_of(entries_);
  std::string all;
  for (const std::vector<char>& names : world.collect({mine.begin(), mine.end()}))
    all.append(names.begin(), names.end());
  world.share(all, 0);
  std::vector<Entry> known;
  std::swap(known, entries_);
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);)
    add(line.substr(1), line[0] == 's' ? EnergyKind::stored : EnergyKind::dissipated, 0);
  for (const Entry& entry : known) add(entry.name, entry.kind, entry.joule);
  std::vector<double> sums{kinetic, kinetic_half};
  sums.insert(sums.end(), std::begin(work), std::end(work));
  sums.insert(sums.end(), std::begin(work_middle), std::end(work_middle));
  for (const Entry& entry : entries_) sums.push_back(entry.joule);
  world.add_up(sums);
  auto next = sums.begin();
  kinetic = *next++;
  kinetic_half = *next++;
  for (double& w : work) w = *next++;
  for (double& w : work_middle) w = *next++;
  for (Entry& entry : entries_) entry.joule = *next++;
}

double Ledger::value(const std::string& name) const {
  for (const Entry& entry : entries_)
    if (entry.name == name) return entry.joule;
  return 0;
}

double Ledger::stored() const {
  double sum = 0;
  for (const Entry& e : entries_) sum += e.kind == EnergyKind::stored ? e.joule : 0;
  return sum;
}

double Ledger::dissipated() const {
  double sum = 0;
  for (const Entry& e : entries_) sum += e.kind == EnergyKind::dissipated ? e.joule : 0;
  return sum;
}

double Ledger::external() const {
  const auto of = [this](ForceClass c) { return work_middle[static_cast<int>(c)]; };
  return of(ForceClass::load) + of(ForceClass::gravity) + of(ForceClass::constraint);
}

double Ledger::residual_1() const {
  double change = kinetic_half - kinetic_start;
  double scale = std::max(kinetic_half, kinetic_start);
  for (const double w : work) {
    change -= w;
    scale = std::max(scale, std::abs(w));
  }
  return ratio(std::abs(change), scale);
}

double Ledger::scale() const {
  return std::max(
      {kinetic, stored(), std::abs(external()), kinetic_start + stored_start, dissipated()});
}

double Ledger::balance() const {
  return kinetic + stored() + dissipated() - kinetic_start - stored_start - external();
}

double Ledger::made() const {
  return balance() + std::max(0.0, -value("CT_numeric"));
}

double Ledger::residual_2() const {
  return ratio(std::abs(balance()), scale());
}

}  // namespace breccia
