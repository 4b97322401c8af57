// A MaterialX document while it is written: elements with attributes, and names that are valid there.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace patina::exporters::mtlx {

struct Element {
    std::string category{};
    std::vector<std::pair<std::string, std::string>> attributes{};
    std::vector<Element> children{};

    Element& add(std::string_view name, std::string value) {
        attributes.emplace_back(name, std::move(value));
        return *this;
    }
};
std::string write_document(const Element& root);

// "0.5, 0.5, 1", as short as a float allows.
std::string numbers_text(const std::vector<double>& numbers);

// Names of one scope.
class Names {
public:
    // The name, with other characters in place of those that a document does not allow, and a number if it is taken.
    std::string unique(std::string_view wanted);

private:
    std::set<std::string> taken_{};
};

}  // namespace patina::exporters::mtlx
