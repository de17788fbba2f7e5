#include "step/ledger.hpp"

#include <algorithm>
#include <cmath>

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
