#include "core/error.hpp"

#include "core/text.hpp"

#include <cstddef>

namespace breccia {

namespace {

constexpr std::size_t shown_at_once = 20;

std::string message(const std::string& place, const std::string& cause, const std::string& remedy) {
  std::string text = place.empty() ? cause : place + ": " + cause;
  if (!remedy.empty()) text += "\n" + indented(remedy, 2);
  return text;
}

std::string message(const std::vector<Error>& together) {
  if (together.empty()) throw std::logic_error("an Error of no errors");
  std::string text;
  for (std::size_t i = 0; i < together.size() && i < shown_at_once; ++i) {
    if (i > 0) text += "\n";
    text += together[i].what();
  }
  if (together.size() > shown_at_once) {
    text += "\nand " + std::to_string(together.size() - shown_at_once) + " more";
  }
  return text;
}

}  // namespace

Error::Error(std::string place, std::string cause, std::string remedy)
    : std::runtime_error(message(place, cause, remedy)),
      place_(std::move(place)),
      cause_(std::move(cause)),
      remedy_(std::move(remedy)) {}

Error::Error(const std::vector<Error>& together)
    : std::runtime_error(message(together)),
      place_(together.front().place()),
      cause_(together.front().cause()),
      remedy_(together.front().remedy()) {}

void Problems::raise() const {
  if (!found_.empty()) throw Error(found_);
}

}  // namespace breccia
