// How code describes sections and keys.
#include "core/schema.hpp"

#include <stdexcept>

namespace breccia {

namespace {

const Place default_place{"default", 0};

}  // namespace

KeyBuilder KeyBuilder::above(double low) {
  key_->range.low = low;
  key_->range.open_low = true;
  return *this;
}
KeyBuilder KeyBuilder::at_least(double low) {
  key_->range.low = low;
  return *this;
}
KeyBuilder KeyBuilder::below(double high) {
  key_->range.high = high;
  key_->range.open_high = true;
  return *this;
}
KeyBuilder KeyBuilder::at_most(double high) {
  key_->range.high = high;
  return *this;
}
KeyBuilder KeyBuilder::between(double low, double high) {
  return at_least(low).at_most(high);
}
KeyBuilder KeyBuilder::required() {
  key_->required = true;
  return *this;
}
KeyBuilder KeyBuilder::by_default(const char* value) {
  key_->default_value = Config(std::string(value), default_place);
  return *this;
}
KeyBuilder KeyBuilder::by_default(double value) {
  key_->default_value = Config(value, default_place);
  return *this;
}
KeyBuilder KeyBuilder::by_default(int value) {
  key_->default_value = Config(std::int64_t{value}, default_place);
  return *this;
}
KeyBuilder KeyBuilder::by_default(bool value) {
  key_->default_value = Config(value, default_place);
  return *this;
}
KeyBuilder KeyBuilder::by_default(const std::vector<std::string>& words) {
  Config::Array list;
  for (const auto& word : words) list.emplace_back(word, default_place);
  key_->default_value = Config(std::move(list), default_place);
  return *this;
}
KeyBuilder KeyBuilder::doc(std::string text) {
  key_->doc = std::move(text);
  return *this;
}
KeyBuilder KeyBuilder::example(std::string text) {
  key_->example = std::move(text);
  return *this;
}
KeyBuilder KeyBuilder::unique() {
  key_->unique = true;
  return *this;
}
KeyBuilder KeyBuilder::identifier() {
  key_->identifier = true;
  return *this;
}
KeyBuilder KeyBuilder::names_file() {
  key_->file = true;
  return *this;
}
KeyBuilder KeyBuilder::only_in(int dimension) {
  key_->only_in = dimension;
  return *this;
}
KeyBuilder KeyBuilder::components_may_be(std::string word) {
  key_->free_word = std::move(word);
  return *this;
}
KeyBuilder KeyBuilder::names_one_of(std::string section) {
  key_->refers_to = std::move(section);
  return *this;
}

SectionBuilder SectionBuilder::doc(std::string text) {
  section_->doc = std::move(text);
  return *this;
}
SectionBuilder SectionBuilder::effect(std::string name) {
  section_->effect = std::move(name);
  return *this;
}
SectionBuilder SectionBuilder::required() {
  section_->required = true;
  return *this;
}
SectionBuilder SectionBuilder::always() {
  section_->always = true;
  return *this;
}
SectionBuilder SectionBuilder::only_in(int dimension) {
  section_->only_in = dimension;
  return *this;
}
SectionBuilder SectionBuilder::names_refer_to(std::string section) {
  section_->names_refer_to = std::move(section);
  return *this;
}
SectionBuilder SectionBuilder::exactly_one_of(std::vector<std::string> names) {
  section_->exactly_one.push_back(std::move(names));
  return *this;
}
SectionBuilder SectionBuilder::at_most_one_of(std::vector<std::string> names) {
  section_->at_most_one.push_back(std::move(names));
  return *this;
}

KeyBuilder SectionBuilder::add(std::string name, KeyType type, Dimension dimension) {
  if (section_->key(name) != nullptr) {
    throw std::logic_error("schema: key " + section_->pattern + "." + name + " is declared twice");
  }
  Key key;
  key.name = std::move(name);
  key.type = type;
  key.dimension = dimension;
  return KeyBuilder(section_->keys.emplace_back(std::move(key)));
}

KeyBuilder SectionBuilder::flag(std::string name) {
  return add(std::move(name), KeyType::flag, unit::none);
}
KeyBuilder SectionBuilder::integer(std::string name) {
  return add(std::move(name), KeyType::integer, unit::none);
}
KeyBuilder SectionBuilder::number(std::string name, Dimension dimension) {
  return add(std::move(name), KeyType::number, dimension);
}
KeyBuilder SectionBuilder::text(std::string name) {
  return add(std::move(name), KeyType::text, unit::none);
}
KeyBuilder SectionBuilder::formula(std::string name) {
  return add(std::move(name), KeyType::formula, unit::none);
}
KeyBuilder SectionBuilder::vector(std::string name, Dimension dimension) {
  return add(std::move(name), KeyType::vector, dimension);
}
KeyBuilder SectionBuilder::rotation(std::string name, Dimension dimension) {
  return add(std::move(name), KeyType::rotation, dimension);
}
KeyBuilder SectionBuilder::numbers(std::string name, Dimension dimension) {
  return add(std::move(name), KeyType::numbers, dimension);
}
KeyBuilder SectionBuilder::integers(std::string name) {
  return add(std::move(name), KeyType::integers, unit::none);
}
KeyBuilder SectionBuilder::texts(std::string name) {
  return add(std::move(name), KeyType::texts, unit::none);
}
KeyBuilder SectionBuilder::values(std::string name) {
  return add(std::move(name), KeyType::values, unit::none);
}
KeyBuilder SectionBuilder::pairs(std::string name) {
  return add(std::move(name), KeyType::pairs, unit::none);
}
KeyBuilder SectionBuilder::points(std::string name, Dimension dimension) {
  return add(std::move(name), KeyType::points, dimension);
}
KeyBuilder SectionBuilder::lines(std::string name, Dimension dimension) {
  return add(std::move(name), KeyType::lines, dimension);
}
KeyBuilder SectionBuilder::choice(std::string name, std::vector<std::string> words) {
  KeyBuilder builder = add(std::move(name), KeyType::choice, unit::none);
  section_->keys.back().choices = std::move(words);
  return builder;
}
KeyBuilder SectionBuilder::table(std::string name, Dimension first, Dimension second) {
  KeyBuilder builder = add(std::move(name), KeyType::table, second);
  section_->keys.back().first_dimension = first;
  return builder;
}

}  // namespace breccia
