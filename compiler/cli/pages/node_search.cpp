#include "compiler/cli/pages/node_search.h"

#include <algorithm>
#include <string>

#include "compiler/cli/pages/page.h"

namespace patina::cli {
namespace {

bool is_upper(char c) {
    return c >= 'A' && c <= 'Z';
}
char lower(char c) {
    return is_upper(c) ? static_cast<char>(c - 'A' + 'a') : c;
}
bool is_word_character(char c) {
    return (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9');
}

std::string spelled_alike(std::string_view name) {
    std::string letters;
    for (const char c : name) {
        if (c != ' ' && c != '_') letters += lower(c);
    }
    return letters;
}

// British and American spellings meet, and so do the plainest endings.
std::string stem(std::string word) {
    for (const auto& [british, american] :
         {std::pair("colour", "color"), std::pair("grey", "gray"), std::pair("centre", "center")}) {
        if (const std::size_t at = word.find(british); at != std::string::npos)
            word.replace(at, std::string_view(british).size(), american);
    }
    for (const std::string_view ending : {"ing", "ed", "s"}) {
        if (word.size() > ending.size() + 3 && word.ends_with(ending)) {
            word.resize(word.size() - ending.size());
            break;
        }
    }
    return word;
}

// "RoundedRectangle at 2 corners": round, rectangle, at, 2, corner.
std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    std::string word;
    const auto end_word = [&] {
        if (!word.empty()) words.push_back(stem(word));
        word.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool begins = i > 0 && is_upper(text[i]) && !is_upper(text[i - 1]);
        if (begins || !is_word_character(text[i])) end_word();
        if (is_word_character(text[i])) word += lower(text[i]);
    }
    end_word();
    return words;
}

struct Text {
    std::vector<std::string> words;
    int weight;
};

std::vector<Text> texts_of(const NodeInfo& node) {
    std::string names = node.name, rest = node.doc;
    for (const std::string& name : node.also) names += " " + name;
    for (const PortInfo& port : node.ports) {
        rest += " " + port.name + " " + port.doc;
        for (const auto& choice : port.enumerators) rest += " " + choice.name + " " + choice.doc;
    }
    return {{words_of(names), 8},
            {words_of(first_sentence(node.doc)), 4},
            {words_of(node.category), 3},
            {words_of(rest), 1}};
}

// The weight of the best text that has the word; a word that only begins with it counts half. 0: none has it.
int weight_of(const std::vector<Text>& texts, const std::string& wanted) {
    int best = 0;
    for (const Text& text : texts) {
        for (const std::string& word : text.words) {
            if (word == wanted) best = std::max(best, 2 * text.weight);
            if (word.starts_with(wanted)) best = std::max(best, text.weight);
        }
    }
    return best;
}

}  // namespace

const NodeInfo* find_named(std::span<const NodeInfo> nodes, std::string_view name) {
    const std::string wanted = spelled_alike(name);
    const NodeInfo* other = nullptr;
    for (const NodeInfo& node : nodes) {
        if (spelled_alike(node.name) == wanted) return &node;
        const auto is_wanted = [&](const std::string& also) { return spelled_alike(also) == wanted; };
        if (!other && std::any_of(node.also.begin(), node.also.end(), is_wanted)) other = &node;
    }
    return other;
}

std::vector<const NodeInfo*> search_nodes(std::span<const NodeInfo> nodes, std::string_view words) {
    const std::vector<std::string> wanted = words_of(words);
    std::vector<std::pair<int, const NodeInfo*>> found;
    for (const NodeInfo& node : nodes) {
        const std::vector<Text> texts = texts_of(node);
        int total = 0;
        const bool has_all = std::all_of(wanted.begin(), wanted.end(), [&](const std::string& word) {
            const int weight = weight_of(texts, word);
            total += weight;
            return weight > 0;
        });
        if (has_all && !wanted.empty()) found.emplace_back(-total, &node);
    }
    std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<const NodeInfo*> best;
    for (const auto& [weight, node] : found) best.push_back(node);
    return best;
}

}  // namespace patina::cli
