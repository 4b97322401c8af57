#include "compiler/importers/unity/yaml.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <sstream>

namespace patina::importers {
namespace {

constexpr std::size_t kMostBytes = 16u << 20;
constexpr std::size_t kMostValues = 1'000'000;
constexpr std::size_t kDeepest = 32;

struct Mistake {
    Place place;
    std::string text;
};

Place place_of(const YAML::Mark& mark) {
    return {.line = mark.line + 1, .column = mark.column + 1};
}

// Makes the trees from the parser's events, so that an alias is seen as what it is.
class Builder : public YAML::EventHandler {
public:
    std::vector<Yaml> documents{};

    void OnDocumentStart(const YAML::Mark&) override { documents.emplace_back(); }
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t) override { add({.place = place_of(mark)}); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
        throw Mistake{place_of(mark), "an alias, which Unity does not write"};
    }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t, const std::string& value) override {
        add({.kind = Yaml::Kind::Text, .text = value, .place = place_of(mark)});
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t,
                         YAML::EmitterStyle::value) override {
        open({.kind = Yaml::Kind::List, .place = place_of(mark)});
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
        open({.kind = Yaml::Kind::Map, .place = place_of(mark)});
    }
    void OnMapEnd() override { close(); }

private:
    void add(Yaml made) {
        if (++count_ > kMostValues)
            throw Mistake{made.place, fmt::format("the file has more than {} values", kMostValues)};
        if (open_.empty()) {
            documents.back() = std::move(made);
            return;
        }
        Yaml& holder = open_.back();
        if (holder.kind == Yaml::Kind::Map && holder.keys.size() == holder.values.size()) {
            if (made.kind != Yaml::Kind::Text) throw Mistake{made.place, "a key is missing"};
            holder.keys.push_back(std::move(made.text));
            holder.key_places.push_back(made.place);
            return;
        }
        holder.values.push_back(std::move(made));
    }
    void open(Yaml made) {
        if (open_.size() >= kDeepest)
            throw Mistake{made.place, fmt::format("more than {} values lie in one another", kDeepest)};
        if (!open_.empty() && open_.back().kind == Yaml::Kind::Map &&
            open_.back().keys.size() == open_.back().values.size())
            throw Mistake{made.place, "a key is a list or a map"};
        open_.push_back(std::move(made));
    }
    void close() {
        Yaml made = std::move(open_.back());
        open_.pop_back();
        add(std::move(made));
    }

    std::vector<Yaml> open_{};  // the outer one first
    std::size_t count_ = 0;
};

std::string located(const std::string& path, Place place, std::string_view text) {
    return fmt::format("{}:{}:{}: {}", path, place.line, place.column, text);
}

}  // namespace

const Yaml* Yaml::find(std::string_view key) const {
    const auto found = std::ranges::find(keys, key);
    const auto index = static_cast<std::size_t>(found - keys.begin());
    return found == keys.end() || index >= values.size() ? nullptr : &values[index];
}

std::string_view Yaml::word(std::string_view key) const {
    const Yaml* value = find(key);
    return value ? std::string_view(value->text) : std::string_view();
}

YamlFile read_yaml(const std::string& path, const std::string& text) {
    if (text.size() > kMostBytes)
        return {.error = fmt::format("{}: the file is larger than {} MiB", path, kMostBytes >> 20)};
    if (text.find('\0') != std::string::npos)
        return {.error = fmt::format("{}: the file is not text; in Unity, set Edit > Project Settings > Editor > Asset "
                                     "Serialization to 'Force Text'",
                                     path)};
    Builder builder;
    try {
        std::istringstream stream(text);
        YAML::Parser parser(stream);
        while (parser.HandleNextDocument(builder)) {
        }
    } catch (const YAML::ParserException& wrong) {
        return {.error = located(path, place_of(wrong.mark), "it is not valid YAML: " + wrong.msg)};
    } catch (const Mistake& wrong) {
        return {.error = located(path, wrong.place, wrong.text)};
    }
    return {.documents = std::move(builder.documents)};
}

}  // namespace patina::importers
