#include "compiler/importers/gltf/gltf_object.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/base/text.h"

namespace patina::importers::gltf {

void Report::add(Remark::Kind kind, const std::string& part, std::string text, const Json* at) {
    Remark& made = remarks.emplace_back(Remark{.kind = kind, .part = part, .text = std::move(text)});
    if (!sources_ || !at) return;
    const Position position = sources_->resolve(at->span.begin);
    made.line = position.line;
    made.column = position.column;
}

void Report::wrong(const std::string& part, const std::string& what, const Json* at) {
    if (!error.empty()) return;
    error = path_;
    if (sources_ && at) {
        const Position position = sources_->resolve(at->span.begin);
        error += fmt::format(":{}:{}", position.line, position.column);
    }
    error += ": " + part + ": " + what;
}

Object::Object(Report& report, const Json* json, std::string path)
    : report_(&report), json_(json), path_(std::move(path)) {
    if (!json_ || json_->kind == Json::Kind::Object) return;
    report.wrong(path_, fmt::format("is {}, not an object", json::describe(json_->kind)), json_);
    json_ = nullptr;
}

std::string Object::part(std::string_view key) const {
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

const Json* Object::find(std::string_view key, Json::Kind kind, std::string_view what) {
    const Json* value = json_ ? json_->find(key) : nullptr;
    if (!value || value->kind == kind) return value;
    report_->wrong(part(key), fmt::format("is {}, not {}", json::describe(value->kind), what), value);
    return nullptr;
}

double Object::within(std::string_view key, const Json& json, double low, double high) {
    const double given = json.number, moved = std::clamp(given, low, high);
    if (moved != given) {
        changed(key, fmt::format("{} instead of {}: the specification allows {} to {}", shortest(moved),
                                 shortest(given), shortest(low), shortest(high)));
    }
    return moved;
}

std::optional<double> Object::number(std::string_view key, double low, double high) {
    const Json* json = find(key, Json::Kind::Number, "a number");
    return json ? std::optional(within(key, *json, low, high)) : std::nullopt;
}

std::optional<std::vector<double>> Object::numbers(std::string_view key, std::size_t count, double low, double high) {
    const Json* json = find(key, Json::Kind::Array, fmt::format("an array of {} numbers", count));
    if (!json) return std::nullopt;
    std::vector<double> made;
    for (const Json& element : json->elements) {
        if (element.kind == Json::Kind::Number) made.push_back(within(key, element, low, high));
    }
    if (made.size() == count && json->elements.size() == count) return made;
    report_->wrong(part(key), fmt::format("is not an array of {} numbers", count), json);
    return std::nullopt;
}

std::optional<bool> Object::flag(std::string_view key) {
    const Json* json = find(key, Json::Kind::Bool, "true or false");
    return json ? std::optional(json->boolean) : std::nullopt;
}

std::optional<std::string> Object::word(std::string_view key) {
    const Json* json = find(key, Json::Kind::String, "a string");
    return json ? std::optional(json->string) : std::nullopt;
}

std::optional<std::size_t> Object::index(std::string_view key, std::string_view list, std::size_t count) {
    const Json* json = find(key, Json::Kind::Number, "a number");
    if (!json) return std::nullopt;
    if (json->number >= 0 && json->number < static_cast<double>(count) && std::floor(json->number) == json->number)
        return static_cast<std::size_t>(json->number);
    report_->wrong(part(key), fmt::format("names {}[{}], and the file has {}", list, shortest(json->number), count),
                   json);
    return std::nullopt;
}

Object Object::child(std::string_view key) {
    if (json_) said_.emplace(key);
    return {*report_, json_ ? json_->find(key) : nullptr, part(key)};
}

Object Object::extension(std::string_view name) {
    const Json* all = find("extensions", Json::Kind::Object, "an object");
    if (all) extensions_.emplace(name);
    return {*report_, all ? all->find(name) : nullptr, part(fmt::format("extensions.{}", name))};
}

void Object::say(Remark::Kind kind, std::string_view key, std::string text) {
    const Json* value = json_ ? json_->find(key) : nullptr;
    if (!value || (kind == Remark::Kind::Taken && said_.contains(key))) return;
    said_.emplace(key);
    report_->add(kind, part(key), std::move(text), value);
}

void Object::taken(std::string_view key, std::string text) {
    say(Remark::Kind::Taken, key, std::move(text));
}
void Object::changed(std::string_view key, std::string text) {
    say(Remark::Kind::Changed, key, std::move(text));
}
void Object::left_out(std::string_view key, std::string why) {
    say(Remark::Kind::LeftOut, key, std::move(why));
}

void Object::all_taken(const std::string& text) {
    if (!json_) return;
    for (const json::JsonMember& member : json_->members) {
        if (member.key != "extensions" && member.key != "extras" && !said_.contains(member.key))
            taken(member.key, text);
    }
}

void Object::rest() {
    if (!json_) return;
    for (const json::JsonMember& member : json_->members) {
        if (said_.contains(member.key)) continue;
        if (member.key != "extensions") {
            left_out(member.key, member.key == "extras" ? "data of another program" : "it is not read");
            continue;
        }
        for (const json::JsonMember& extension : member.value.members) {
            if (extensions_.contains(extension.key)) continue;
            report_->add(Remark::Kind::LeftOut, part("extensions." + extension.key), "the extension is not read",
                         &extension.value);
        }
    }
}

}  // namespace patina::importers::gltf
