// Whether the readers of a name read what their author meant, in a text with one side of each conflict. Of a name that
// the two sides have for different things, the text holds the thing of one side: then only readers that this side has
// may read it.
//
//   std::string problem = misread_name(ours, theirs, text);   // "": each reads what it should
#pragma once

#include <rapidjson/document.h>
#include <rapidjson/stringbuffer.h>
#include <rapidjson/writer.h>

#include <cctype>
#include <set>

#include "unit/edit/graph_values.h"

namespace patina {

// "n12" and "_P3" are names. All but `kept` become "?": the other side may have renamed them.
inline std::string without_names(const std::string& text, const std::string& kept) {
    const auto is_word = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    std::string made;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && is_word(text[end])) ++end;
        const std::string word = text.substr(at, std::max<std::size_t>(end - at, 1));
        const bool is_name = word.size() > 1 && std::isdigit(static_cast<unsigned char>(word.back())) &&
                             (word.starts_with("_P") || (word[0] == 'n' && std::isdigit(word[1])));
        made += is_name && word != kept ? "?" : word;
        at += word.size();
    }
    return made;
}

// The things and the readers of one text.
class NamesOfText {
public:
    explicit NamesOfText(const std::string& text) {
        json_.Parse<rapidjson::kParseCommentsFlag>(text.c_str());
        if (json_.HasParseError()) return;
        for (const char* list : {"nodes", "properties"}) {
            if (!json_.HasMember(list)) continue;
            for (auto& each : json_[list].GetArray()) {
                const char* key = each.HasMember("id") ? "id" : "name";
                const std::string name = each[key].GetString();
                each.RemoveMember(key);
                std::map<std::string, std::string> values;  // the order of keys is no meaning
                add_values(each, "", values);
                for (const auto& [place, value] : values) things_[name] += place + "=" + value + ";";
                for (const auto& value : values) values_.insert(value);
            }
        }
        std::map<std::string, std::string> surface;
        add_values(json_["surface"], "surface", surface);
        values_.insert(surface.begin(), surface.end());
    }

    bool has(const std::string& name) const { return things_.count(name) != 0; }
    std::string thing(const std::string& name) const { return without_names(things_.at(name), ""); }
    std::set<std::string> names() const {
        std::set<std::string> names;
        for (const auto& each : things_) names.insert(each.first);
        return names;
    }
    // Each with the last part of its place.
    std::set<std::string> readers(const std::string& name) const {
        std::set<std::string> readers;
        for (const auto& [place, value] : values_) {
            const std::string read = without_names(value, name);
            if (read != without_names(value, "")) readers.insert(place + ": " + read);
        }
        return readers;
    }

private:
    static void add_values(const rapidjson::Value& value, const std::string& place,
                           std::map<std::string, std::string>& values) {
        if (value.IsObject()) {
            for (const auto& each : value.GetObject())
                add_values(each.value, place + "/" + each.name.GetString(), values);
            return;
        }
        rapidjson::StringBuffer buffer;
        rapidjson::Writer<rapidjson::StringBuffer> writer(buffer);
        value.Accept(writer);
        values[place] = buffer.GetString();
    }

    rapidjson::Document json_;
    std::map<std::string, std::string> things_{};
    std::set<std::pair<std::string, std::string>> values_{};
};

// `checked`: counts the names that tell something.
inline std::string misread_name(const Values& ours, const Values& theirs, const std::string& taken, int& checked) {
    const NamesOfText text(taken),
        sides[] = {NamesOfText(Writer(ours, nullptr).write()), NamesOfText(Writer(theirs, nullptr).write())};
    const auto path_of = [](const Values& values, const std::string& name) {
        for (const auto& [path, value] : values) {
            if (value == name && (path.ends_with("/id") || path.ends_with("/name"))) return path;
        }
        return std::string();
    };
    for (const std::string& name : text.names()) {
        if (!sides[0].has(name) || !sides[1].has(name) || path_of(ours, name) == path_of(theirs, name)) continue;
        if (sides[0].thing(name) == sides[1].thing(name)) continue;
        for (const NamesOfText& side : sides) {
            if (text.thing(name) != side.thing(name)) continue;
            ++checked;
            const std::set<std::string> meant = side.readers(name);
            for (const std::string& reader : text.readers(name)) {
                if (!meant.count(reader)) return "this reads another '" + name + "' than its author meant: " + reader;
            }
        }
    }
    return {};
}

}  // namespace patina
