#include "compiler/importers/gltf/own_names.h"

#include <algorithm>
#include <cctype>

namespace patina::importers::gltf {

std::string OwnNames::own(const std::string& name) {
    std::string made = name;
    for (int& number = next_.try_emplace(key(name), 2).first->second; !taken_.insert(key(made)).second; ++number)
        made = name + before_number_ + std::to_string(number);
    return made;
}

std::string OwnNames::key(std::string name) const {
    if (tells_capitals_) return name;
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
    return name;
}

}  // namespace patina::importers::gltf
