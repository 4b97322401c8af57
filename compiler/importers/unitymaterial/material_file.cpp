#include "compiler/importers/unitymaterial/material_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "compiler/base/letters.h"
#include "compiler/importers/source_text.h"

namespace patina::importers::unitymaterial {
namespace {

// An entry of a list of properties, in whatever form.
struct Entry {
    std::string name{};
    const Yaml* value = nullptr;
    Place place{};
};

// "first: {name: _Color}, second: {...}", the old form.
Entry old_entry(const Yaml& pair) {
    const Yaml* first = pair.find("first");
    const Yaml* second = pair.find("second");
    if (!first || !second) return {};
    return {.name = std::string(first->kind == Yaml::Kind::Text ? std::string_view(first->text) : first->word("name")),
            .value = second,
            .place = first->place};
}

std::vector<Entry> entries_of(const Yaml* list) {
    std::vector<Entry> made;
    if (!list) return made;
    for (std::size_t i = 0; i < list->values.size(); ++i) {
        const Yaml& each = list->values[i];
        if (each.kind != Yaml::Kind::Map) continue;
        if (each.find("first")) {
            made.push_back(old_entry(each));
        } else if (list->kind == Yaml::Kind::List) {
            for (std::size_t k = 0; k < each.values.size(); ++k)
                made.push_back({.name = each.keys[k], .value = &each.values[k], .place = each.key_places[k]});
        }
    }
    // A map of names, which some tools write.
    if (list->kind == Yaml::Kind::Map && made.empty())
        for (std::size_t i = 0; i < list->values.size(); ++i)
            made.push_back({.name = list->keys[i], .value = &list->values[i], .place = list->key_places[i]});
    std::erase_if(made, [](const Entry& each) { return each.name.empty() || !each.value; });
    return made;
}

AssetId asset_of(const Yaml* value) {
    AssetId made;
    if (!value || value->kind != Yaml::Kind::Map) return made;
    const std::string_view file = value->word("fileID");
    std::from_chars(file.data(), file.data() + file.size(), made.file);
    made.guid = small_letters(std::string(value->word("guid")));
    if (made.guid.find_first_not_of('0') == made.guid.npos) made.guid.clear();
    return made;
}

// "a list", "'7'"
std::string shown(const Yaml& value) {
    switch (value.kind) {
        case Yaml::Kind::Null: return "nothing";
        case Yaml::Kind::Text: return "'" + value.text.substr(0, 40) + "'";
        case Yaml::Kind::List: return "a list";
        case Yaml::Kind::Map: return "a map";
    }
    return {};
}

constexpr std::string_view kCutOff = "; the file may be cut off";

class Reader {
public:
    Reader(const Yaml& material, MaterialFile& made) : material_(material), made_(made) {}

    void read() {
        made_.name = material_.word("m_Name");
        const bool is_newer = version(material_, "the file", 8);
        for (std::size_t i = 0; i < material_.values.size(); ++i) {
            const std::string& key = material_.keys[i];
            const Yaml& value = material_.values[i];
            if (key == "m_Name" || (key == "serializedVersion" && is_newer)) continue;
            if (key == "m_Shader" || key == "m_Parent") {
                expect_map(value, key + " is {fileID: ..., guid: ..., type: ...}");
                (key == "m_Shader" ? made_.shader : made_.parent) = asset_of(&value);
                (key == "m_Shader" ? made_.shader_place : made_.parent_place) = material_.key_places[i];
            } else if (key == "m_ShaderKeywords" || key == "m_ValidKeywords") {
                keywords(value, made_.keywords);
            } else if (key == "m_InvalidKeywords") {
                keywords(value, made_.invalid_keywords);
            } else if (key == "m_SavedProperties") {
                properties(value);
            } else {
                setting(key, value, material_.key_places[i]);
            }
        }
        if (!material_.find("m_SavedProperties"))
            problem("setting 'm_SavedProperties'", fmt::format("it is missing: the shader's defaults count{}", kCutOff),
                    material_.place);
    }

private:
    void problem(std::string part, std::string text, Place place) {
        made_.problems.push_back({.part = std::move(part), .text = std::move(text), .place = place});
    }

    // What a text editor or a merge made of it, and Unity never writes.
    void wrong(Place place, std::string_view text) {
        if (made_.error.empty()) made_.error = fmt::format("{}:{}:{}: {}", made_.path, place.line, place.column, text);
    }
    bool expect_map(const Yaml& value, std::string_view what) {
        const bool is_good = value.kind == Yaml::Kind::Map || value.kind == Yaml::Kind::Null;
        if (!is_good) wrong(value.place, fmt::format("{}, and not {}", what, shown(value)));
        return is_good;
    }

    // The properties at a key.
    std::vector<Entry> list_at(const Yaml& saved, std::string_view key) {
        const Yaml* list = saved.find(key);
        if (!list) {
            // Files of older versions have no m_Ints.
            if (key != "m_Ints")
                problem(fmt::format("setting '{}'", key), fmt::format("the file has no {}{}", key, kCutOff),
                        saved.place);
            return {};
        }
        if (list->kind != Yaml::Kind::List) expect_map(*list, fmt::format("{} is a list of properties", key));
        for (const Yaml& each : list->values) {
            if (list->kind == Yaml::Kind::List && each.kind == Yaml::Kind::Null)
                wrong(each.place, fmt::format("an entry of {} is empty", key));
            if (list->kind == Yaml::Kind::List)
                expect_map(each, fmt::format("an entry of {} is a name and a value", key));
            if (each.kind == Yaml::Kind::Map && each.find("first") && !each.find("second"))
                wrong(each.place, fmt::format("an entry of {} has 'first', and no 'second'", key));
        }
        return entries_of(list);
    }

    // A list of words, or one text with spaces between them.
    void keywords(const Yaml& value, std::vector<SavedKeyword>& into) {
        const auto add = [&](std::string_view text, Place place) {
            for (std::size_t begin = 0; begin < text.size();) {
                const std::size_t end = std::min(text.find(' ', begin), text.size());
                const std::string name(text.substr(begin, end - begin));
                if (!name.empty() && std::ranges::find(into, name, &SavedKeyword::name) == into.end())
                    into.push_back({.name = name, .place = place});
                begin = end + 1;
            }
        };
        add(value.text, value.place);
        if (value.kind == Yaml::Kind::Map) wrong(value.place, "the keywords are a list of words, and not a map");
        if (value.kind == Yaml::Kind::List)
            for (const Yaml& each : value.values) {
                if (each.kind != Yaml::Kind::Text && each.kind != Yaml::Kind::Null)
                    wrong(each.place, fmt::format("a keyword is a word, and not {}", shown(each)));
                add(each.text, each.place);
            }
    }

    void setting(const std::string& key, const Yaml& value, Place place) {
        Setting made{.key = key, .text = value.text, .place = place};
        if (value.kind == Yaml::Kind::List)
            for (const Yaml& each : value.values) made.words.push_back(each.text);
        if (value.kind == Yaml::Kind::Map) {
            for (const Entry& each : entries_of(&value)) made.words.push_back(each.name + "=" + each.value->text);
        }
        made_.settings.push_back(std::move(made));
    }

    // False: the property is there already. The first one counts.
    bool is_new(const Entry& entry, std::string_view list) {
        if (names_.emplace(list, entry.name).second) return true;
        problem(fmt::format("property '{}'", entry.name), "it is there twice: the first one counts", entry.place);
        return false;
    }

    bool number(const Entry& entry, const Yaml* value, double& into) {
        if (value && read_finite(value->text, into)) return true;
        if (value && (value->kind == Yaml::Kind::List || value->kind == Yaml::Kind::Map))
            wrong(value->place, fmt::format("the number of '{}' is {}", entry.name, shown(*value)));
        const bool is_empty = !value || value->kind == Yaml::Kind::Null;
        problem(fmt::format("property '{}'", entry.name),
                fmt::format("'{}' is not a finite number: the shader's default counts",
                            is_empty ? std::string_view("nothing") : value->text),
                value ? value->place : entry.place);
        return false;
    }

    bool version(const Yaml& map, std::string part, int newest) {
        const Yaml* found = map.find("serializedVersion");
        double number = 0;
        if (!found || !read_finite(found->text, number) || number <= newest) return false;
        problem(std::move(part),
                fmt::format("it is of version {}; {} is the newest that is known: read as that", found->text, newest),
                found->place);
        return true;
    }

    void properties(const Yaml& saved) {
        if (!expect_map(saved, "m_SavedProperties holds m_TexEnvs, m_Floats and m_Colors")) return;
        version(saved, "setting 'm_SavedProperties'", 3);
        for (const std::string_view key : {"m_Floats", "m_Ints"})
            for (const Entry& each : list_at(saved, key)) {
                SavedNumber made{.place = each.place};
                if (is_new(each, "numbers") && number(each, each.value, made.value)) made_.numbers[each.name] = made;
            }
        for (const Entry& each : list_at(saved, "m_Colors")) {
            SavedColor made{.place = each.place};
            bool is_good = is_new(each, "colors") &&
                           expect_map(*each.value,
                                      fmt::format("the colour '{}' is {{r: ..., g: ..., b: ..., a: ...}}", each.name));
            static constexpr std::string_view kChannels[] = {"r", "g", "b", "a"};
            for (std::size_t i = 0; i < 4 && is_good; ++i)
                is_good = number(each, each.value->find(kChannels[i]), made.value[i]);
            if (is_good) made_.colors[each.name] = made;
        }
        for (const Entry& each : list_at(saved, "m_TexEnvs")) texture(each);
    }

    void texture(const Entry& entry) {
        if (!is_new(entry, "textures")) return;
        if (!expect_map(*entry.value, fmt::format("the texture '{}' has m_Texture, m_Scale and m_Offset", entry.name)))
            return;
        SavedTexture made{.place = entry.place};
        bool is_good = true;
        for (const std::string_view key : {"m_Texture", "m_Scale", "m_Offset"}) {
            const Yaml* value = entry.value->find(key);
            if (!value || value->kind == Yaml::Kind::Null) {
                problem(fmt::format("property '{}'", entry.name), fmt::format("it has no {}{}", key, kCutOff),
                        entry.place);
                continue;
            }
            if (key == "m_Texture") {
                expect_map(*value, "m_Texture is {fileID: ..., guid: ..., type: ...}");
                made.picture = asset_of(value);
            } else if (expect_map(*value, fmt::format("{} is {{x: ..., y: ...}}", key)) && is_good) {
                auto& pair = key == "m_Scale" ? made.scale : made.offset;
                is_good = number(entry, value->find("x"), pair[0]) && number(entry, value->find("y"), pair[1]);
            }
        }
        if (is_good) made_.textures[entry.name] = made;
    }

    const Yaml& material_;
    MaterialFile& made_;
    std::set<std::pair<std::string_view, std::string>> names_{};  // list, name
};

}  // namespace

bool read_finite(std::string_view text, double& number) {
    float made = 0;
    const auto [end, wrong] = std::from_chars(text.data(), text.data() + text.size(), made);
    if (wrong != std::errc() || end != text.data() + text.size() || !std::isfinite(made)) return false;
    number = static_cast<double>(made);
    return true;
}

const Setting* MaterialFile::setting(std::string_view key) const {
    const auto found = std::ranges::find(settings, key, &Setting::key);
    return found == settings.end() ? nullptr : &*found;
}

bool MaterialFile::has(const std::string& property) const {
    return numbers.contains(property) || colors.contains(property) || textures.contains(property);
}

MaterialFile read_material(const std::string& path, bool is_named_by_user) {
    std::string why;
    const std::optional<std::string> text =
        is_named_by_user ? read_text(path, why) : read_named_text(path, kMaterials, why);
    if (!text) return {.error = std::move(why)};
    const YamlFile yaml = read_yaml(path, *text);
    if (!yaml.error.empty()) return {.error = yaml.error};
    MaterialFile made{.path = path};
    bool has_one = false;
    for (const Yaml& document : yaml.documents) {
        const Yaml* material = document.find("Material");
        if (!material) continue;
        if (material->kind != Yaml::Kind::Map) {
            const Place place = document.key_places[static_cast<std::size_t>(material - document.values.data())];
            return {.error = fmt::format("{}:{}:{}: the material has no values: the file is cut off", path, place.line,
                                         place.column)};
        }
        if (has_one) {
            made.problems.push_back(
                {.part = "material", .text = "there are several: the first one counts", .place = material->place});
            continue;
        }
        has_one = true;
        Reader(*material, made).read();
        if (!made.error.empty()) return {.error = made.error};
    }
    if (!has_one) return {.error = fmt::format("{}: there is no material in it", path)};
    return made;
}

}  // namespace patina::importers::unitymaterial
