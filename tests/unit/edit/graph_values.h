// Graphs as values with keys that no rename touches, for generated merges, and the texts that people might write of
// them.
//
//   Values values{{"nodes/7", ""}, {"nodes/7/id", "mask"}, {"nodes/7/expr", "\"{9} * 2\""}};
//   std::string text = Writer(values, nullptr).write();
#pragma once

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace patina {

// "nodes/7/in/scale" -> "4", "nodes/7" -> "" (it is there). Names are values: "nodes/7/id". In a
// value, {7} stands for the name of node 7, and {p3} for that of property 3.
using Values = std::map<std::string, std::string>;

inline bool is_below(const std::string& path, const std::string& parent) {
    return path.size() > parent.size() && path.starts_with(parent) && path[parent.size()] == '/';
}

// The keys of a list, in the order in which their things were made.
inline std::vector<int> keys_of(const Values& values, const std::string& list) {
    std::vector<int> keys;
    for (const auto& [path, value] : values) {
        if (is_below(path, list) && path.find('/', list.size() + 1) == path.npos)
            keys.push_back(std::stoi(path.substr(list.size() + 1)));
    }
    std::sort(keys.begin(), keys.end());
    return keys;
}

inline std::string at(const Values& values, const std::string& path) {
    const auto found = values.find(path);
    return found == values.end() ? std::string() : found->second;
}

inline std::string node(int key) {
    return "nodes/" + std::to_string(key);
}
inline std::string property(int key) {
    return "properties/" + std::to_string(key);
}

inline std::string with_names(const Values& values, const std::string& text) {
    std::string made;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '{') {
            made += text[i];
            continue;
        }
        const std::size_t end = text.find('}', i);
        const std::string key = text.substr(i + 1, end - i - 1);
        const std::string name =
            at(values, key[0] == 'p' ? "properties/" + key.substr(1) + "/name" : "nodes/" + key + "/id");
        made += std::string(key[0] == 'p' ? "$" : "") + (name.empty() ? "nothing_of_this_name" : name);
        i = end;
    }
    return made;
}

class Dice {
public:
    explicit Dice(unsigned seed) : engine_(seed) {}
    int below(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    bool chance(int percent) { return below(100) < percent; }
    template <class T>
    const T& pick(const std::vector<T>& of) {
        return of[static_cast<std::size_t>(below(static_cast<int>(of.size())))];
    }

private:
    std::mt19937 engine_;
};

inline std::string quoted(const std::string& text) {
    return "\"" + text + "\"";
}

// Objects in another order, with comments, on one line or several: as people leave files.
class Writer {
public:
    Writer(const Values& values, Dice* mess) : values_(values), mess_(mess) {}

    std::string write() {
        std::vector<std::string> members = {R"("patina": 1)", R"("workflow": "unlit")"};
        const auto add_list = [&](const std::string& list) {
            std::vector<int> keys = keys_of(values_, list);
            if (list == "properties") {
                const auto place = [&](int key) { return std::stoi(at(values_, property(key) + "/@place")); };
                std::stable_sort(keys.begin(), keys.end(), [&](int a, int b) { return place(a) < place(b); });
            } else if (mess_) {
                for (std::size_t i = keys.size(); i > 1; --i)
                    std::swap(keys[i - 1], keys[std::size_t(mess_->below(int(i)))]);
            }
            if (keys.empty()) return;
            std::string text = quoted(list) + ": [";
            for (std::size_t i = 0; i < keys.size(); ++i) {
                if (mess_ && mess_->chance(20)) text += "\n    // " + list + " " + std::to_string(keys[i]);
                text += "\n    " + object(list + "/" + std::to_string(keys[i])) + (i + 1 < keys.size() ? "," : "");
                if (mess_ && mess_->chance(10)) text += " // behind";
            }
            members.push_back(text + "\n  ]");
        };
        add_list("properties");
        add_list("nodes");
        for (const char* each : {"surface", "render", "meta"}) {
            if (values_.count(each)) members.push_back(quoted(each) + ": " + object(each));
        }
        std::string text = "{";
        for (std::size_t i = 0; i < members.size(); ++i) text += (i > 0 ? ",\n  " : "\n  ") + members[i];
        return text + "\n}\n";
    }

private:
    std::string object(const std::string& path) {
        std::vector<std::string> members;
        for (const auto& [child, value] : values_) {
            if (!is_below(child, path) || child.find('/', path.size() + 1) != child.npos) continue;
            const std::string key = child.substr(path.size() + 1);
            if (key[0] == '@') continue;
            const bool is_name = key == "id" || key == "name";
            members.push_back(quoted(key) + ": " +
                              (value.empty() ? object(child)
                               : is_name     ? quoted(value)
                                             : with_names(values_, value)));
        }
        const bool lines = mess_ && mess_->chance(15);
        std::string text = "{";
        for (std::size_t i = 0; i < members.size(); ++i)
            text += (i > 0 ? "," : "") + std::string(lines ? "\n      " : " ") + members[i];
        return text + (lines ? "\n    }" : " }");
    }

    const Values& values_;
    Dice* mess_;
};

}  // namespace patina
