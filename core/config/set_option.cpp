#include "core/config/set_option.h"

#include "core/check.h"
#include "core/config/quantity.h"
#include "core/config/yaml_scalar.h"

namespace mapbed {
namespace {

// One overload for each type an option can have.
struct Writer {
  const Option& option;
  const ConfigNode& node;

  void operator()(double* value) const { *value = node.number(option.unit, option.bounds); }
  void operator()(int* value) const { *value = node.whole_number(option.bounds); }
  void operator()(std::uint64_t* value) const { *value = node.unsigned_number(option.bounds); }
  void operator()(bool* value) const { *value = node.flag(); }
  void operator()(std::string* value) const { *value = node.text(); }
  void operator()(std::vector<double>* value) const {
    *value = node.numbers(option.unit, option.bounds);
  }
  void operator()(std::vector<int>* value) const { *value = node.whole_numbers(option.bounds); }
  void operator()(std::vector<std::string>* value) const { *value = node.texts(); }
  void operator()(const Choice& choice) const {
    choice.set(choice.field, node.choice(choice.names));
  }
};

struct Printer {
  const Option& option;

  std::string text(double value) const { return quantity_text(value, option.unit); }
  std::string text(int value) const { return std::to_string(value); }
  std::string text(const std::string& value) const { return yaml_scalar(value); }

  template <class T>
  std::string operator()(std::vector<T>* values) const {
    std::string result;
    for (const T& value : *values) result += (result.empty() ? "" : ", ") + text(value);
    return "[" + result + "]";
  }
  std::string operator()(double* value) const { return text(*value); }
  std::string operator()(int* value) const { return text(*value); }
  std::string operator()(std::uint64_t* value) const { return std::to_string(*value); }
  std::string operator()(bool* value) const { return *value ? "true" : "false"; }
  std::string operator()(std::string* value) const { return text(*value); }
  std::string operator()(const Choice& choice) const {
    const int index = choice.get(choice.field);
    CHECK(index >= 0 && static_cast<std::size_t>(index) < choice.names.size());
    return yaml_scalar(choice.names[static_cast<std::size_t>(index)]);
  }
};

}  // namespace

void set_option(const Option& option, const ConfigNode& node) {
  std::visit(Writer{option, node}, option.value);
}

std::string option_text(const Option& option) {
  return std::visit(Printer{option}, option.value);
}

bool is_list(const Option& option) {
  return std::holds_alternative<std::vector<double>*>(option.value) ||
         std::holds_alternative<std::vector<int>*>(option.value) ||
         std::holds_alternative<std::vector<std::string>*>(option.value);
}

}  // namespace mapbed
