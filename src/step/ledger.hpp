#pragma once
#include "core/world.hpp"

#include <string>
#include <vector>

namespace breccia {

/// Classes of force whose work is booked step by step (level 1 of ALGORITHMS ).
enum class ForceClass {
  element,
  interface,
  contact,
  load,
  gravity,
  constraint,
  relaxation,
  absorber,
  excavation,  ///< mass that left with its kinetic energy; not a force
  count_
};
inline constexpr int kForceClasses = static_cast<int>(ForceClass::count_);

/// What an energy of level 2 is.
enum class EnergyKind { stored, dissipated };

/// Energies of the scene at one instant, J. Modules add to it by the names of.
class Ledger {
 public:
  /// Adds to the entry `name`, which is made where it does not exist.
  void add(const std::string& name, EnergyKind kind, double joule);
  double value(const std::string& name) const;  ///< 0 where there is no such entry

  struct Entry {
    std::string name;
    EnergyKind kind;
    double joule;
  };
  const std::vector<Entry>& entries() const { return entries_; }

  /// Of the parts that the ranks know, the whole; what was there at the start is known to all.
  /// Collective.
  void merge(const World& world);

  double kinetic = 0;                      ///< at t^n, from v^(n-1/2).v^(n+1/2)
  double kinetic_half = 0;                 ///< at t^(n+1/2)
  double work[kForceClasses] = {};         ///< booked up to t^(n+1/2), J
  double work_middle[kForceClasses] = {};  ///< booked up to t^n
  double kinetic_start = 0;
  double stored_start = 0;

  double stored() const;
  double dissipated() const;
  /// Work of loads, gravity and prescribed motion up to t^n.
  double external() const;
  /// Kinetic + stored + dissipated - external - start.
  double balance() const;
  /// Largest energy in play.
  double scale() const;
  /// Energy that came from nowhere (below zero: that was lost): what the books do not explain, and
  /// what they explain by numerics.
  double made() const;
  /// Round-off check: change of kinetic energy minus the work of all forces, over the largest
  /// energy in play.
  double residual_1() const;
  /// Consistency check: the balance over the largest energy.
  double residual_2() const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace breccia
