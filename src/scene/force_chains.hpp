#pragma once
#include "io/vtkhdf.hpp"
#include "scene/fragments.hpp"
#include "step/observation.hpp"

#include <vector>

namespace breccia {

/// Contacts as lines between fragments: for each two fragments that touch, a leg from the centre of
/// one to where they press and a leg from there to the centre of the other, with the force on the
/// leg's own fragment. Contacts within a fragment (the sides of a crack) have no lines.
class ForceChains {
 public:
  ForceChains(int dimension, const std::vector<Touch>& touches, const Fragments& fragments);

  /// Lines; the arrays are borrowed from this object.
  Frame frame(double time, std::int64_t step) const;

 private:
  struct Contact;
  void add_leg(std::int32_t first, const Contact& contact, Index own, Index other, double sign,
               const Fragments& fragments);

  int dimension_;
  std::vector<double> points_, force_, size_, partner_size_;
  std::vector<std::int32_t> connectivity_, fragment_, partner_, contacts_;
};

}  // namespace breccia
