#include "compiler/cli/licences/licences.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace patina::cli {
namespace {

// Expressions of licences can be long, so the products have a line of their own.
void print_row(const ComponentLicence& component, std::string_view products) {
    const std::string_view version = component.version == "NOASSERTION" ? "unknown" : component.version;
    print(fmt::format("  {:<14} {:<12} {}\n{:29}{}\n", component.name, version, component.licence, "", products));
}

void print_list() {
    print("Patina " + std::string(version()) +
          ", MIT. What Patina makes of your graphs is yours: the licence sets no conditions for it.\n"
          "The textures of the examples and the pictures drawn of the examples: CC0-1.0.\n\n"
          "Code of these is in Patina's programs and libraries:\n");
    for (const ComponentLicence& component : component_licences())
        if (!component.code_in.empty()) print_row(component, fmt::format("in {}", component.code_in));
    print("\nThese are loaded as shared libraries:\n");
    for (const ComponentLicence& component : component_licences())
        if (!component.loaded_by.empty()) print_row(component, fmt::format("by {}", component.loaded_by));
    print(
        "\n'patina --licences NAME' prints the text of one, 'patina --licences all' prints all. They are also files "
        "in\n"
        "share/doc/patina/licences, and share/patina/patina.spdx.json is this list for programs (SPDX).\n");
}

void print_texts(std::string_view name) {
    if (name == "patina" || name == "all") print(own_licence());
    for (const ComponentLicence& component : component_licences()) {
        if (component.text.empty() || (name != component.name && name != "all")) continue;
        print(fmt::format("{}----- {} {}\n\n{}", name == "all" ? "\n" : "", component.name, component.version,
                          component.text));
    }
}

std::vector<std::string> names_with_texts() {
    std::vector<std::string> names{"all", "patina"};
    for (const ComponentLicence& component : component_licences())
        if (!component.text.empty()) names.emplace_back(component.name);
    return names;
}

}  // namespace

void add_licences_option(Program& program) {
    program.app
        .add_option_function<std::string>(
            "--licences,--licenses",
            [](const std::string& name) {
                if (name.empty()) {
                    print_list();
                } else {
                    print_texts(name);
                }
                throw CLI::Success();
            },
            "List whose code is in Patina and under which licences, and exit; with NAME or 'all': print the texts")
        ->type_name("[NAME]")
        ->expected(0, 1)
        ->check(CLI::Validator([check = one_of("a part of Patina with a text of its own", names_with_texts())](
                                   const std::string& name) { return name.empty() ? std::string() : check(name); },
                               ""));
}

}  // namespace patina::cli
