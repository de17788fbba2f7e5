#include "step/friction_keys.hpp"

#include "core/text.hpp"

#include <algorithm>
#include <array>

namespace breccia {

namespace {

/// A law, and the keys that it needs.
struct FrictionWord {
  const char* word;
  FrictionKind kind;
  std::vector<std::string> needs;
};

const std::array<FrictionWord, 6>& friction_words() {
  static const std::array<FrictionWord, 6> words{
      {{"coulomb", FrictionKind::coulomb, {}},
       {"static_dynamic", FrictionKind::static_dynamic, {"dynamic", "weakening_speed"}},
       {"slip_weakening", FrictionKind::slip_weakening, {"dynamic", "weakening_slip"}},
       {"velocity_weakening", FrictionKind::velocity_weakening, {"dynamic", "weakening_speed"}},
       {"ageing", FrictionKind::ageing, {"a", "b", "state_slip"}},
       {"slip_law", FrictionKind::slip_law, {"a", "b", "state_slip"}}}};
  return words;
}

const FrictionWord& word_of(const Settings& friction) {
  const std::string& law = friction.text("law");
  return *std::find_if(friction_words().begin(), friction_words().end(),
                       [&](const FrictionWord& w) { return law == w.word; });
}

void add_rate_and_state_keys(SectionBuilder& s) {
  s.number("a", unit::none)
      .above(0)
      .at_most(1)
      .example("0.010")
      .doc("Rate and state: direct effect.");
  s.number("b", unit::none)
      .between(0, 1)
      .example("0.015")
      .doc("Rate and state: effect of the state.");
  s.number("state_slip", unit::length)
      .above(0)
      .example("10 um")
      .doc("Rate and state: slip over which the state evolves.");
  s.number("reference_speed", unit::velocity)
      .above(0)
      .by_default("1 um/s")
      .doc(
          "Rate and state: slip rate at which friction in steady state is its coefficient at "
          "rest.");
  s.number("state", unit::time)
      .above(0)
      .example("10 s")
      .doc("Rate and state: state variable at the start; steady at the reference speed if absent.");
}

}  // namespace

void add_friction_keys(SectionBuilder& s) {
  std::vector<std::string> words;
  for (const FrictionWord& w : friction_words()) words.emplace_back(w.word);
  s.choice("law", words)
      .by_default("coulomb")
      .doc(
          "Law of friction. coulomb: one coefficient; static_dynamic: falls with "
          "exp(-V / weakening_speed); "
          "slip_weakening: falls in a line over weakening_slip; velocity_weakening: falls with "
          "1 / (1 + V / weakening_speed); ageing, slip_law: rate and state.");
  s.number("dynamic", unit::none)
      .between(0, 10)
      .example("0.4")
      .doc("Friction of sliding, for the laws that weaken.");
  s.number("weakening_slip", unit::length)
      .above(0)
      .example("0.4 m")
      .doc("Slip over which slip_weakening goes down to `dynamic`.");
  s.number("weakening_speed", unit::velocity)
      .above(0)
      .example("0.1 m/s")
      .doc("Slip rate of static_dynamic and velocity_weakening.");
  add_rate_and_state_keys(s);
}

void check_friction(const Settings& friction, const char* coefficient, Problems& problems) {
  const FrictionWord& law = word_of(friction);
  const auto& needs = law.needs;
  for (const std::string& key : needs)
    if (!friction.has(key))
      problems.add(friction.error(key, std::string("is missing; ") + law.word + " needs it"));
  const bool has_state = std::find(needs.begin(), needs.end(), "a") != needs.end();
  for (const char* key : {"dynamic", "weakening_slip", "weakening_speed", "a", "b", "state_slip",
                          "reference_speed", "state"}) {
    const bool of_state = std::string(key) == "reference_speed" || std::string(key) == "state";
    const bool used =
        (of_state && has_state) || std::find(needs.begin(), needs.end(), key) != needs.end();
    if (friction.given(key) && !used)
      problems.add(friction.error(key, std::string("is not a number of law = \"") + law.word + "\"",
                                  "choose the law that it belongs to, or leave it out"));
  }
  const bool weakens = !needs.empty() && needs.front() == "dynamic";
  if (weakens && friction.has("dynamic") &&
      friction.number("dynamic") > friction.number(coefficient))
    problems.add(friction.error("dynamic",
                                number_text(friction.number("dynamic")) + " is above " +
                                    coefficient + " = " + number_text(friction.number(coefficient)),
                                "what weakens slides with less friction"));
}

FrictionLaw read_friction(const Settings& s, const char* coefficient) {
  FrictionLaw law;
  law.kind = word_of(s).kind;
  law.at_rest = s.number(coefficient);
  law.sliding = s.has("dynamic") ? s.number("dynamic") : law.at_rest;
  if (s.has("weakening_slip")) law.length = s.number("weakening_slip");
  if (s.has("weakening_speed")) law.speed = s.number("weakening_speed");
  if (!law.has_state()) return law;
  law.length = s.number("state_slip");
  law.speed = s.number("reference_speed");
  law.a = s.number("a");
  law.b = s.number("b");
  law.state = s.has("state") ? s.number("state") : law.length / law.speed;
  return law;
}

bool contact_remembers(const Settings& scene) {
  if (!scene.has("contact")) return false;
  const Settings& contact = scene.at("contact");
  const auto& pairs = contact.list("pair");
  return contact.text("law") != "coulomb" ||
         std::any_of(pairs.begin(), pairs.end(),
                     [](const Settings& pair) { return pair.text("law") != "coulomb"; });
}

}  // namespace breccia
