#include "compiler/json/json_text.h"

#include <fmt/format.h>

namespace patina::json {
namespace {

// Writes `[` or `{`, the items and the closing bracket.
bool append_items(std::string& out, const Json& json, const SourceMap& sources, std::size_t limit) {
    const bool is_object = json.kind == Json::Kind::Object;
    const std::size_t count = is_object ? json.members.size() : json.elements.size();
    if (count == 0) {
        out += is_object ? "{}" : "[]";
        return out.size() <= limit;
    }
    out += is_object ? "{ " : "[";
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) out += ", ";
        if (is_object) {
            append_quoted(out, json.members[i].key);
            out += ": ";
        }
        if (!append_one_line(out, is_object ? json.members[i].value : json.elements[i], sources, limit)) return false;
    }
    out += is_object ? " }" : "]";
    return out.size() <= limit;
}

}  // namespace

std::string canonical_number(std::string_view raw) {
    const std::size_t e = raw.find_first_of("eE");
    std::string_view mantissa = raw.substr(0, e);
    std::string_view exponent = e == std::string_view::npos ? std::string_view() : raw.substr(e + 1);

    const bool has_point = mantissa.find('.') != std::string_view::npos;
    while (has_point && mantissa.ends_with('0')) mantissa.remove_suffix(1);
    std::string text(mantissa);
    if (text.ends_with('.')) text += '0';  // 1.0 stays what it is: 1 would be a whole number

    const bool negative = exponent.starts_with('-');
    while (!exponent.empty() && (exponent[0] == '-' || exponent[0] == '+' || exponent[0] == '0')) {
        exponent.remove_prefix(1);
    }
    if (!exponent.empty()) {
        text += negative ? "e-" : "e";
        text += exponent;
    } else if (e != std::string_view::npos && !has_point) {
        text += ".0";
    }
    return text;
}

void append_quoted(std::string& out, std::string_view text) {
    out += '"';
    for (const char c : text) {
        switch (c) {
            case '"': out += "\\\""; break;
            case '\\': out += "\\\\"; break;
            case '\b': out += "\\b"; break;
            case '\f': out += "\\f"; break;
            case '\n': out += "\\n"; break;
            case '\r': out += "\\r"; break;
            case '\t': out += "\\t"; break;
            default:
                if (static_cast<unsigned char>(c) < 0x20) {
                    out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
                } else {
                    out += c;
                }
        }
    }
    out += '"';
}

bool append_one_line(std::string& out, const Json& json, const SourceMap& sources, std::size_t limit) {
    switch (json.kind) {
        case Json::Kind::Null: out += "null"; break;
        case Json::Kind::Bool: out += json.boolean ? "true" : "false"; break;
        case Json::Kind::Number: out += canonical_number(sources.text(json.span)); break;
        case Json::Kind::String: append_quoted(out, json.string); break;
        case Json::Kind::Array:
        case Json::Kind::Object: return append_items(out, json, sources, limit);
    }
    return out.size() <= limit;
}

}  // namespace patina::json
