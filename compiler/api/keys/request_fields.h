// What a compilation is asked for, as a text that no other request has.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "patina/options.h"

namespace patina {

// A list of values as one text, which no other list has.
class Fields {
public:
    Fields& add(std::string_view value) {
        text_ += std::to_string(value.size());
        text_ += ' ';
        text_ += value;
        return *this;
    }
    Fields& add_flag(bool value) { return add(value ? "1" : "0"); }
    Fields& add(const std::vector<std::string>& values) {
        add(std::to_string(values.size()));
        for (const std::string& value : values) add(value);
        return *this;
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

// All options but Limits and the functions of FileSystem.
void add_options(Fields& fields, const CompileOptions& options);

}  // namespace patina
