#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace breccia {

/// Something the user can put right: where it is, what is wrong, what to do.
///
/// `what()` reads "place: cause", then the remedy on indented lines. Broken invariants of the code
/// are std::logic_error, never this. The command line turns an Error into exit status 2.
class Error : public std::runtime_error {
 public:
  /// `place` is "file:line", a key path or a file; it may be empty where nothing is known yet.
  Error(std::string place, std::string cause, std::string remedy = {});

  /// Several errors reported as one; the first gives place and cause.
  explicit Error(const std::vector<Error>& together);

  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] const std::string& cause() const { return cause_; }
  [[nodiscard]] const std::string& remedy() const { return remedy_; }

  /// The same error with another place.
  [[nodiscard]] Error at(std::string place) const { return {std::move(place), cause_, remedy_}; }

 private:
  std::string place_, cause_, remedy_;
};

/// Collects the errors of one scene, so that a user sees all of them at once.
class Problems {
 public:
  void add(Error error) { found_.push_back(std::move(error)); }
  void add(std::string place, std::string cause, std::string remedy = {}) {
    found_.emplace_back(std::move(place), std::move(cause), std::move(remedy));
  }
  [[nodiscard]] bool empty() const { return found_.empty(); }
  [[nodiscard]] const std::vector<Error>& found() const { return found_; }

  /// Throws one Error that holds everything found (the first 20 in full); returns if there is none.
  void raise() const;

 private:
  std::vector<Error> found_;
};

}  // namespace breccia
