#pragma once
#include "loops/contact_flyers.hpp"
#include "step/clock.hpp"
#include "step/model.hpp"
#include "step/module.hpp"

#include <vector>

namespace breccia {

/// What a look at the pieces that fly has found.
struct FlyingLook {
  std::int64_t steps = 0;  ///< until the next look; 0: a search is due
  double speed = 0;        ///< of the fastest node that does not fly, m/s
  bool late = false;       ///< something has moved farther than was foreseen
};

/// Pieces that have left their place since the last search, and touch nothing before the next look:
/// their boxes, moved on, are clear of all others, and within themselves they have moved less than
/// half the skin. For their sake no search is needed (ALGORITHMS, ejecta).
template <int D>
class ContactFlyers {
 public:
  /// After a search.
  void start();
  /// True where a look may spare a search; looks that have found nothing make it wait.
  bool worth_a_look();
  /// `since`: steps since the last look; `longest`: most steps to the next one.
  FlyingLook look(const Model<D>& model, const Clock& clock, const ContactSurface<D>& surface,
                  double skin, std::int64_t since, double longest);
  std::size_t bytes() const;
  void archive(Archive& archive);

 private:
  using P = ContactPieces<D>;
  void number(const Model<D>& model, const ContactSurface<D>& surface);
  double number_of(std::size_t piece, int column) const;
  bool late(const Clock& clock, double skin) const;
  void foresee(double time, double skin);

  P pieces_;
  PieceReach<D> reach_;
  std::vector<double> numbers_;       ///< of the pieces, on the host
  std::vector<Index> flying_;         ///< pieces
  std::vector<double> seen_, bound_;  ///< per piece: its shift at the last look, how far it may go
  bool numbered_ = false, flies_ = false;
  std::int64_t releases_ = 0, misses_ = 0, wait_ = 0;
};

}  // namespace breccia
