#include "compiler/json/json.h"

#include <fmt/format.h>
#include <rapidjson/reader.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <unordered_map>

#include "compiler/base/cancellation.h"
#include "compiler/base/text.h"
#include "compiler/json/json_errors.h"
#include "compiler/json/memory/json_memory.h"
#include "compiler/json/other_file.h"

namespace patina::json {
namespace {

// To read so many bytes takes about as long as to make an instruction.
constexpr std::uint32_t kBytesOfAStep = 256;

// RapidJSON reads through this. RapidJSON copies some kinds of streams while it reads a token. It does not copy this
// one, so Tell() is right in every callback.
class Cursor {
public:
    using Ch = char;
    Cursor(std::string_view text, std::size_t from)
        : begin_(text.data()), at_(begin_ + from), end_(begin_ + text.size()) {}

    Ch Peek() const { return at_ == end_ ? '\0' : *at_; }
    Ch Take() { return at_ == end_ ? '\0' : *at_++; }
    std::size_t Tell() const { return static_cast<std::size_t>(at_ - begin_); }

    // Only in-situ parsing writes; the reader names these all the same.
    Ch* PutBegin() { return nullptr; }
    void Put(Ch) { assert(false); }
    void Flush() { assert(false); }
    std::size_t PutEnd(Ch*) { return 0; }

private:
    const char* begin_;
    const char* at_;
    const char* end_;
};

// Names already seen in one object. Small objects are searched, large ones hashed.
class SeenKeys {
public:
    // The span of an earlier member of that name, or nowhere.
    Span find_or_add(const std::vector<JsonMember>& members, const std::string& key, Span span) {
        if (members.size() < kFew) {
            for (const JsonMember& member : members) {
                if (member.key == key) return member.key_span;
            }
            return {};
        }
        if (by_name_.empty()) {
            for (const JsonMember& member : members) by_name_.emplace(member.key, member.key_span);
        }
        const auto [found, added] = by_name_.emplace(key, span);
        return added ? Span{} : found->second;
    }

private:
    static constexpr std::size_t kFew = 16;
    std::unordered_map<std::string, Span> by_name_;
};

JsonComments& comments_of(Json& json) {
    if (!json.comments) json.comments = std::make_unique<JsonComments>();
    return *json.comments;
}

// A number of JSON; infinite: it is too large. One that is too small is 0.
double number_of(std::string_view text) {
    const double value = read_number(text).value_or(std::numeric_limits<double>::infinity());
    if (std::isfinite(value)) return value;
    // Out of range. The distance of the first nonzero digit from the decimal point decides whether the number is too
    // large or too small.
    const std::size_t e = std::min(text.find_first_of("eE"), text.size());
    const std::string_view digits = text.substr(0, e);
    const std::size_t point = std::min(digits.find('.'), digits.size()), first = digits.find_first_of("123456789");
    const double places = static_cast<double>(point) - static_cast<double>(first);
    const double exponent =
        e < text.size() ? read_number(text.substr(text[e + 1] == '+' ? e + 2 : e + 1)).value_or(0) : 0;
    return places + exponent < 0 ? 0 : value;
}

// Makes the tree of RapidJSON's events. The text between two tokens is read a second time here, to find the comments
// and where the next token starts: an event knows only where it ends.
class Builder {
public:
    Builder(std::string_view text, std::uint32_t base, const Cursor& cursor, std::size_t start,
            Diagnostics& diagnostics)
        : text_(text), base_(base), cursor_(cursor), last_begin_(start), last_end_(start), diagnostics_(diagnostics) {}

    // --- RapidJSON's handler
    bool Null() { return scalar(Json::Kind::Null); }
    bool Bool(bool value) {
        if (!scalar(Json::Kind::Bool)) return false;
        last_value()->boolean = value;
        return true;
    }
    // RapidJSON's own conversion is not defined for a zero with a large exponent: 0e75.
    bool RawNumber(const char* digits, rapidjson::SizeType size, bool) {
        const double value = number_of({digits, size});
        has_large_number_ = !std::isfinite(value);
        if (has_large_number_ || !scalar(Json::Kind::Number)) return false;
        last_value()->number = value;
        return true;
    }
    // These are called without kParseNumbersAsStringsFlag only.
    bool Int(int) { return false; }
    bool Uint(unsigned) { return false; }
    bool Int64(std::int64_t) { return false; }
    bool Uint64(std::uint64_t) { return false; }
    bool Double(double) { return false; }
    bool String(const char* value, rapidjson::SizeType size, bool) {
        if (!scalar(Json::Kind::String)) return false;
        last_value()->string.assign(value, size);
        return check_decoded(last_value()->string);
    }
    bool Key(const char* value, rapidjson::SizeType size, bool) {
        begin_token();
        end_token(cursor_.Tell());
        Frame& frame = frames_.back();
        frame.key.assign(value, size);
        frame.key_span = {global(last_begin_) + 1, global(last_end_) - 1};
        last_ = Token::Key;
        Cancellation::step(1 + size / kBytesOfAStep);
        if (!check_decoded(frame.key)) return false;
        const Span first = frame.seen.find_or_add(frame.json.members, frame.key, frame.key_span);
        frame.drop = static_cast<bool>(first);
        if (first) {
            diagnostics_.report(Code::DuplicateKey, frame.key_span, shown(frame.key))
                .note(first, "the first one is here");
        }
        return true;
    }
    bool StartObject() { return open(Json::Kind::Object); }
    bool StartArray() { return open(Json::Kind::Array); }
    bool EndObject(rapidjson::SizeType) { return close(); }
    bool EndArray(rapidjson::SizeType) { return close(); }

    // --- afterwards
    bool finish() {
        begin_token();  // comments after the root
        if (!count({global(last_begin_), global(last_begin_)})) return false;
        drop_blank_ends(pending_);
        if (pending_.empty()) return true;
        std::string& trailing = comments_of(*root_).trailing;
        for (std::string& comment : pending_) {
            if (!trailing.empty()) trailing += '\n';
            trailing += comment;
        }
        return true;
    }
    std::unique_ptr<Json> take_root() { return std::move(root_); }
    JsonBreak where() const {
        JsonBreak at;
        at.code = has_large_number_ ? rapidjson::kParseErrorNumberTooBig : rapidjson::kParseErrorTermination;
        at.last_begin = last_begin_;
        at.last_end = last_end_;
        if (!frames_.empty()) {
            const Json& json = frames_.back().json;
            at.bracket = json.kind == Json::Kind::Object ? '{' : '[';
            at.bracket_offset = json.span.begin - base_;
        }
        return at;
    }

private:
    enum class Token { Opening, Key, Value };  // Value: a scalar or a closing bracket

    struct Frame {
        Json json;
        std::string key;  // of the member that is being read
        Span key_span;
        bool drop = false;  // that member is a duplicate
        SeenKeys seen;
    };

    std::uint32_t global(std::size_t offset) const { return base_ + static_cast<std::uint32_t>(offset); }

    // The value that ended with the last token; null after a key or an opening bracket.
    Json* last_value() {
        if (last_ != Token::Value) return nullptr;
        if (frames_.empty()) return root_.get();
        Frame& frame = frames_.back();
        if (frame.drop) return &dropped_;
        return frame.json.kind == Json::Kind::Object ? &frame.json.members.back().value : &frame.json.elements.back();
    }

    // What has been seen since the last token.
    struct Gap {
        bool same_line = true;  // as that token
        bool comma = false;
        int newlines = 0;  // since the last comment
        std::optional<bool> comments_end_line;
    };

    void begin_token();
    void end_token(std::size_t end) { last_end_ = end; }
    // `i` is at the comment, and afterwards behind it.
    void read_comment(std::size_t& i, Gap& gap);
    bool ends_line(std::size_t i) const;
    static void drop_blank_ends(std::vector<std::string>& comments);

    bool scalar(Json::Kind kind);
    bool open(Json::Kind kind);
    bool close();
    void place(Json json);
    bool count(Span span);
    bool check_decoded(const std::string& text);

    std::string_view text_;
    std::uint32_t base_;
    const Cursor& cursor_;
    std::size_t last_begin_, last_end_;
    Token last_ = Token::Opening;
    bool has_large_number_ = false;
    std::vector<Frame> frames_;
    std::unique_ptr<Json> root_;
    Json dropped_;
    std::vector<std::string> pending_;  // comments waiting for the next value or closing bracket
    std::size_t items_ = 0;
    Diagnostics& diagnostics_;
};

// True if only white space, commas and one-line comments follow on the line.
bool Builder::ends_line(std::size_t i) const {
    while (i < text_.size() && text_[i] != '\n') {
        if (text_.substr(i, 2) == "//") return true;
        if (text_.substr(i, 2) == "/*") {
            const std::size_t close = text_.find("*/", i + 2);
            if (text_.substr(i, close - i).find('\n') != std::string_view::npos) return true;
            i = close + 2;
        } else if (text_[i] == ' ' || text_[i] == '\t' || text_[i] == '\r' || text_[i] == ',') {
            ++i;
        } else {
            return false;
        }
    }
    return true;
}

// A comment belongs to the value before it if it is on the same line and is before the comma or last on the line. Any
// other comment belongs to what follows.
void Builder::read_comment(std::size_t& i, Gap& gap) {
    const bool line = text_[i + 1] == '/';
    const std::size_t begin = i;
    i = line ? std::min(text_.find('\n', i), text_.size()) : text_.find("*/", i + 2) + 2;
    gap.newlines = 0;
    Cancellation::step();
    if (++items_ > kMaxJsonItems) return;  // the next count() refuses the file

    std::string comment(text_.substr(begin, i - begin));
    std::erase(comment, '\r');
    while (line && (comment.back() == ' ' || comment.back() == '\t')) comment.pop_back();
    if (comment.find('\n') != std::string::npos) gap.same_line = false;

    Json* value = frames_.empty() ? nullptr : last_value();  // what follows the root is listed line by line
    bool trails = gap.same_line && value;
    if (trails && gap.comma) {
        if (!gap.comments_end_line) gap.comments_end_line = ends_line(i);
        trails = *gap.comments_end_line;
    }
    if (trails) {
        std::string& trailing = comments_of(*value).trailing;
        if (!trailing.empty()) trailing += ' ';
        trailing += comment;
    } else {
        gap.same_line = false;
        pending_.push_back(std::move(comment));
    }
}

void Builder::begin_token() {
    Gap gap;
    std::size_t i = last_end_;
    while (i < text_.size()) {
        const char c = text_[i];
        if (c == '/') {
            read_comment(i, gap);
            continue;
        }
        if (c == '\n') {
            gap.same_line = false;
            // One blank line is kept, but none at the start of an object, nor behind a key.
            const bool separates = pending_.empty() ? last_ == Token::Value : !pending_.back().empty();
            if (++gap.newlines == 2 && separates && last_ != Token::Key) pending_.emplace_back();
        } else if (c == ',') {
            gap.comma = true;
        } else if (c != ' ' && c != '\t' && c != '\r' && c != ':') {
            break;
        }
        ++i;
    }
    last_begin_ = i;
}

void Builder::drop_blank_ends(std::vector<std::string>& comments) {
    while (!comments.empty() && comments.back().empty()) comments.pop_back();
}

// A tree needs far more memory than its text: without a limit, a file of 64 MiB could need several GiB.
bool Builder::count(Span span) {
    Cancellation::step(1 + (span.end - span.begin) / kBytesOfAStep);
    if (++items_ <= kMaxJsonItems) return true;
    diagnostics_.report(Code::TooMany, span, items_, "JSON values", kMaxJsonItems);
    return false;
}

// Escapes can make what the text itself cannot hold.
bool Builder::check_decoded(const std::string& text) {
    const Span span{global(last_begin_), global(last_end_)};
    std::size_t bad = 0;
    if (text.find('\0') != std::string::npos) {
        diagnostics_.report(Code::BadJson, span, "a string cannot hold the character \\u0000");
        return false;
    }
    if (!is_utf8(text, bad)) {
        diagnostics_.report(Code::BadJson, span, "the string holds half of a surrogate pair");
        return false;
    }
    return true;
}

void Builder::place(Json json) {
    last_ = Token::Value;
    if (frames_.empty()) {
        root_ = std::make_unique<Json>(std::move(json));
        return;
    }
    Frame& frame = frames_.back();
    if (frame.drop) {
        dropped_ = std::move(json);
    } else if (frame.json.kind == Json::Kind::Object) {
        frame.json.members.push_back({std::move(frame.key), frame.key_span, std::move(json)});
    } else {
        frame.json.elements.push_back(std::move(json));
    }
}

bool Builder::scalar(Json::Kind kind) {
    begin_token();
    end_token(cursor_.Tell());
    Json json;
    json.kind = kind;
    json.span = {global(last_begin_), global(last_end_)};
    if (!pending_.empty()) comments_of(json).before.swap(pending_);
    if (!count(json.span)) return false;
    place(std::move(json));
    return true;
}

bool Builder::open(Json::Kind kind) {
    begin_token();
    end_token(last_begin_ + 1);
    const Span bracket{global(last_begin_), global(last_end_)};
    if (frames_.size() >= kMaxJsonDepth) {
        diagnostics_.report(Code::TooDeep, bracket, kMaxJsonDepth);
        return false;
    }
    if (!count(bracket)) return false;
    Frame& frame = frames_.emplace_back();
    frame.json.kind = kind;
    frame.json.span = bracket;
    if (!pending_.empty()) comments_of(frame.json).before.swap(pending_);
    last_ = Token::Opening;
    return true;
}

bool Builder::close() {
    begin_token();
    end_token(last_begin_ + 1);
    Json json = std::move(frames_.back().json);
    frames_.pop_back();
    drop_blank_ends(pending_);
    if (!pending_.empty()) comments_of(json).end.swap(pending_);
    json.span.end = global(last_end_);
    place(std::move(json));
    return true;
}

// Checks the text before parsing. Returns the offset of the first byte to parse, or nothing after an error.
std::optional<std::size_t> check_text(std::string_view text, std::uint32_t base, Diagnostics& diagnostics) {
    const Span start{base, base};
    if (text.empty()) {
        diagnostics.report(Code::EmptyFile, start);
        return std::nullopt;
    }
    if (text.size() > kMaxJsonBytes) {
        diagnostics.report(Code::TooLarge, start, text.size(), kMaxJsonBytes);
        return std::nullopt;
    }
    std::size_t bad = 0;
    if (!is_utf8(text, bad)) {
        const std::uint32_t at = base + static_cast<std::uint32_t>(bad);
        DiagnosticRecord& record =
            diagnostics.report(Code::NotUtf8, Span{at, at + 1}, bad + 1, static_cast<unsigned char>(text[bad]));
        if (const std::string_view kind = binary_kind(text); !kind.empty()) record.note(std::string(kind));
        return std::nullopt;
    }
    if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos) {
        const std::uint32_t at = base + static_cast<std::uint32_t>(zero);
        diagnostics.report(Code::BadJson, Span{at, at + 1}, "a text cannot hold a zero byte");
        return std::nullopt;
    }
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    return text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
}

}  // namespace

std::unique_ptr<Json> parse_json(const SourceMap& sources, std::uint32_t base, Diagnostics& diagnostics, JsonOf whose) {
    if (whose == JsonOf::Patina && report_other_file(sources.file(base), base, diagnostics)) return nullptr;
    const std::string_view text = sources.file_text(base);
    const std::optional<std::size_t> start = check_text(text, base, diagnostics);
    if (!start) return nullptr;

    constexpr unsigned kFlags = rapidjson::kParseIterativeFlag | rapidjson::kParseCommentsFlag |
                                rapidjson::kParseTrailingCommasFlag | rapidjson::kParseNumbersAsStringsFlag |
                                rapidjson::kParseValidateEncodingFlag;
    Cursor cursor(text, *start);
    Builder builder(text, base, cursor, *start, diagnostics);
    rapidjson::GenericReader<rapidjson::UTF8<>, rapidjson::UTF8<>, JsonMemory> reader;
    const rapidjson::ParseResult result = reader.Parse<kFlags>(cursor, builder);
    if (result.IsError()) {
        JsonBreak at = builder.where();
        if (result.Code() != rapidjson::kParseErrorTermination) at.code = result.Code();
        at.offset = result.Offset();
        report_json_break(text, base, at, diagnostics);
        return nullptr;
    }
    return builder.finish() ? builder.take_root() : nullptr;
}

const Json* Json::find(std::string_view key) const {
    for (const JsonMember& member : members) {
        if (member.key == key) return &member.value;
    }
    return nullptr;
}

std::string_view describe(Json::Kind kind) {
    switch (kind) {
        case Json::Kind::Null: return "null";
        case Json::Kind::Bool: return "true or false";
        case Json::Kind::Number: return "a number";
        case Json::Kind::String: return "a string";
        case Json::Kind::Array: return "an array";
        case Json::Kind::Object: return "an object";
    }
    return {};
}

std::string shown(std::string_view text) {
    constexpr std::size_t kMaxShown = 80;
    if (text.size() <= kMaxShown) return std::string(text);
    std::size_t cut = kMaxShown;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0u) == 0x80u) --cut;
    return std::string(text.substr(0, cut)) + "...";
}

std::vector<std::uint32_t> string_offsets(const Json& string, const SourceMap& sources) {
    const std::string_view raw = sources.text(string.span);
    if (string.kind != Json::Kind::String || raw.find('\\') == std::string_view::npos) return {};

    const auto code_unit = [&](std::size_t i) { return std::stoul(std::string(raw.substr(i + 2, 4)), nullptr, 16); };
    std::vector<std::uint32_t> offsets;
    offsets.reserve(string.string.size() + 1);
    std::size_t i = 1;
    while (i + 1 < raw.size()) {
        std::size_t read = 1, written = 1;  // bytes of the text, bytes of the decoded string
        if (raw[i] == '\\' && raw[i + 1] != 'u') {
            read = 2;
        } else if (raw[i] == '\\') {
            const unsigned long unit = code_unit(i);
            const bool pair = unit >= 0xD800 && unit < 0xDC00;
            read = pair ? 12 : 6;
            written = pair ? 4 : unit < 0x80 ? 1 : unit < 0x800 ? 2 : 3;
        }
        offsets.insert(offsets.end(), written, string.span.begin + static_cast<std::uint32_t>(i));
        i += read;
    }
    offsets.push_back(string.span.end - 1);
    assert(offsets.size() == string.string.size() + 1);
    return offsets;
}

}  // namespace patina::json
