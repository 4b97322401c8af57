// Names that no two things share: a name that is taken gets the next number. A model may have thousands of materials of
// one name, so no number is tried twice.
//
//   OwnNames names('-');
//   names.own("glass");   // "glass"
//   names.own("glass");   // "glass-2"
#pragma once

#include <map>
#include <set>
#include <string>

namespace patina::importers::gltf {

class OwnNames {
public:
    // `before_number`: what stands between a name and its number.
    explicit OwnNames(char before_number, bool tells_capitals = true)
        : before_number_(before_number), tells_capitals_(tells_capitals) {}

    std::string own(const std::string& name);

private:
    std::string key(std::string name) const;

    char before_number_;
    bool tells_capitals_;
    std::set<std::string> taken_{};
    std::map<std::string, int> next_{};  // by the name without a number: the number that may be free
};

}  // namespace patina::importers::gltf
