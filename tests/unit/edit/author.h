// Makes graphs and changes of them that a person might make, from dice. A change may break the graph: who asks for it
// compiles the result.
//
//   Author author(values, dice, 1000);   // new things get keys from 1000
//   author.change();
#pragma once

#include <set>

#include "unit/edit/graph_values.h"

namespace patina {

// Each value has one number or three.
class Author {
public:
    Author(Values& values, Dice& dice, int first_key) : values_(values), dice_(dice), next_key_(first_key) {
        for (const auto& [path, value] : values_) {
            if (path.ends_with("/id") || path.ends_with("/name")) used_.insert(value);
        }
    }

    void make_base() {
        values_["surface"] = "";
        for (int i = 0, count = 1 + dice_.below(3); i < count; ++i) add_property();
        for (int i = 0, count = 2 + dice_.below(5); i < count; ++i) add_node();
        values_["surface/color"] = port(3);
        if (dice_.chance(60)) values_["surface/alpha"] = port(1);
    }

    void change() {
        switch (dice_.below(13)) {
            case 0:
            case 1: return change_a_port();
            case 2: return add_and_use();
            case 3: return remove_a_node();
            case 4: return rename_a_node();
            case 5: return rename_a_property();
            case 6: return change_a_property();
            case 7: return add_property();
            case 8: return remove_a_property();
            case 9: return rewrite_a_node();
            case 10: return change_render();
            case 11: return swap_properties();
            default: return change_meta();
        }
    }

    // Gives a name of the graph to another thing: swaps two names, or renames a thing and calls another one, or a new
    // one, by its old name. False: the texts do not tell the things apart.
    bool reuse_a_name() {
        const bool is_node = dice_.chance(60);
        const std::string list = is_node ? "nodes" : "properties", key = is_node ? "/id" : "/name";
        const std::vector<int> keys = keys_of(values_, list);
        const auto path_of = [&](int thing) { return list + "/" + std::to_string(thing); };
        const int a = dice_.pick(keys), how = dice_.below(4);
        const bool read_a = is_read(list, a);
        std::string& name = values_[path_of(a) + key];
        if (how == 0) {
            const std::string old = name;
            name = free_name(is_node ? "n" : "_P");
            const int b = next_key_;
            is_node ? void(add_node()) : add_property();
            values_[path_of(b) + key] = old;
            return !is_alike(path_of(a), path_of(b)) && (read_a || !is_of_one_kind(path_of(a), path_of(b)));
        }
        const int b = dice_.pick(keys);
        if (a == b) return false;
        // Of properties that are declared alike, readers tell which is which.
        const bool read_b = is_read(list, b);
        if (is_alike(path_of(a), path_of(b)) && (is_node || !read_a || !read_b)) return false;
        if (is_of_one_kind(path_of(a), path_of(b)) && !read_a && !read_b) return false;
        std::swap(name, values_[path_of(b) + key]);
        if (how == 1) name = free_name(is_node ? "n" : "_P");
        return true;
    }

private:
    bool is_of_one_kind(const std::string& a, const std::string& b) const {
        return at(values_, a + "/node") == at(values_, b + "/node") &&
               at(values_, a + "/type") == at(values_, b + "/type");
    }
    bool is_read(const std::string& list, int key) const {
        const std::string name = (list == "nodes" ? "{" : "{p") + std::to_string(key) + "}";
        return std::any_of(values_.begin(), values_.end(),
                           [&](const auto& each) { return each.second.find(name) != std::string::npos; });
    }
    bool is_alike(const std::string& a, const std::string& b) const {
        const auto content = [&](const std::string& path) {
            Values values;
            for (const auto& [each, value] : values_) {
                const bool is_content = is_below(each, path) && each != path + "/id" && each != path + "/name";
                if (is_content && each.find('@') == each.npos) values[each.substr(path.size())] = value;
            }
            return values;
        };
        return content(a) == content(b);
    }

    // Never one that there was: a name is all by which a merge knows a thing.
    std::string free_name(const char* letter) {
        std::string name;
        do name = letter + std::to_string(dice_.below(40));
        while (!used_.insert(name).second);
        return name;
    }

    // An operand with that many components.
    std::string operand(int width, int without = -1) {
        std::vector<std::string> all = {width == 1 ? "0.25" : "float3(0.5, 0.25, 1)",
                                        width == 1 ? "@time" : "@positionWS"};
        for (int key : keys_of(values_, "nodes")) {
            if (key == without) continue;
            const bool same = at(values_, node(key) + "/@width") == std::to_string(width);
            const std::string name = "{" + std::to_string(key) + "}";
            all.push_back(same ? name : width == 1 ? name + ".x" : "float3(" + name + ")");
        }
        for (int key : keys_of(values_, "properties")) {
            const std::string name = "{p" + std::to_string(key) + "}";
            const bool is_color = at(values_, property(key) + "/type") == "\"color\"";
            all.push_back(width == 1 ? (is_color ? name + ".r" : name)
                                     : (is_color ? name + ".rgb" : "float3(" + name + ")"));
        }
        return dice_.pick(all);
    }
    std::string expression(int width, int without = -1) {
        const std::string a = operand(width, without);
        switch (dice_.below(4)) {
            case 0: return a + " * " + std::to_string(1 + dice_.below(9));
            case 1: return a + " + " + operand(width, without);
            case 2: return "saturate(" + a + ")";
            default: return a;
        }
    }
    std::string port(int width, int without = -1) {
        if (dice_.chance(30)) return width == 1 ? "0." + std::to_string(1 + dice_.below(9)) : quoted("#c9a27e");
        return quoted("= " + expression(width, without));
    }

    int content(int key) {
        const std::string path = node(key);
        std::erase_if(values_, [&](const auto& each) {
            return is_below(each.first, path) && each.first != path + "/id" && each.first != path + "/@width";
        });
        int width = dice_.chance(50) ? 1 : 3;
        if (values_.count(path + "/@width")) width = std::stoi(values_[path + "/@width"]);
        switch (dice_.below(3)) {
            case 0: values_[path + "/expr"] = quoted(expression(width, key)); break;
            case 1:
                values_[path + "/node"] = quoted("Lerp");
                values_[path + "/in"] = "";
                values_[path + "/in/from"] = port(width, key);
                values_[path + "/in/to"] = quoted("= " + expression(width, key));
                if (dice_.chance(70)) values_[path + "/in/t"] = port(1, key);
                break;
            default:
                values_[path + "/node"] = quoted(width == 1 ? "GradientNoise" : "Saturate");
                values_[path + "/in"] = "";
                values_[path + (width == 1 ? "/in/scale" : "/in/value")] = port(width, key);
                break;
        }
        if (dice_.chance(10)) values_[path + "/note"] = quoted("note " + std::to_string(dice_.below(9)));
        return width;
    }

    int add_node() {
        const int key = next_key_++;
        const std::string name = free_name("n");
        const int width = content(key);
        values_[node(key)] = "";
        values_[node(key) + "/id"] = name;
        values_[node(key) + "/@width"] = std::to_string(width);
        return key;
    }
    void add_property() {
        const int key = next_key_++;
        const std::string name = free_name("_P");
        const bool is_color = dice_.chance(40);
        values_[property(key)] = "";
        values_[property(key) + "/name"] = name;
        values_[property(key) + "/type"] = quoted(is_color ? "color" : "float");
        values_[property(key) + "/default"] = is_color ? quoted("#40c0ff") : "0." + std::to_string(1 + dice_.below(9));
        values_[property(key) + "/@place"] = std::to_string(key);
    }

    std::vector<std::string> ports() const {
        std::vector<std::string> paths;
        for (const auto& [path, value] : values_) {
            if (path.find("/in/") != path.npos || path.ends_with("/expr") || is_below(path, "surface"))
                paths.push_back(path);
        }
        return paths;
    }
    static int owner_of(const std::string& path) { return path.starts_with("nodes/") ? std::stoi(path.substr(6)) : -1; }
    int width_of(const std::string& path) const {
        if (path == "surface/color") return 3;
        if (path == "surface/alpha" || path.ends_with("/t") || path.ends_with("/scale")) return 1;
        return std::stoi(at(values_, node(owner_of(path)) + "/@width"));
    }
    void set_port(const std::string& path, const std::string& read) {
        const bool is_bare = path.ends_with("/expr");
        values_[path] = quoted(is_bare ? read : "= " + read);
    }

    void change_a_port() {
        const std::string path = dice_.pick(ports());
        const bool is_bare = path.ends_with("/expr");
        values_[path] =
            is_bare ? quoted(expression(width_of(path), owner_of(path))) : port(width_of(path), owner_of(path));
    }
    void add_and_use() {
        const int key = add_node();
        std::vector<std::string> paths;
        for (const std::string& path : ports()) {
            if (owner_of(path) != key) paths.push_back(path);
        }
        const std::string path = dice_.pick(paths);
        const bool same = at(values_, node(key) + "/@width") == std::to_string(width_of(path));
        const std::string name = "{" + std::to_string(key) + "}";
        set_port(path, same ? name : width_of(path) == 1 ? name + ".x" : "float3(" + name + ")");
    }
    // Whoever read it gets a number.
    void replace_reads(const std::string& name) {
        for (const std::string& path : ports()) {
            if (values_[path].find(name) == std::string::npos) continue;
            if (path.ends_with("/expr")) {
                values_[path] = quoted(width_of(path) == 1 ? "0.125" : "float3(0.125, 1, 0)");
            } else {
                values_[path] = width_of(path) == 1 ? "0.125" : "[0.125, 1, 0]";
            }
        }
    }
    void remove(const std::string& path, const std::string& name) {
        std::erase_if(values_, [&](const auto& each) { return each.first == path || is_below(each.first, path); });
        replace_reads(name);
    }
    void remove_a_node() {
        const std::vector<int> keys = keys_of(values_, "nodes");
        if (keys.size() < 2) return;
        const int key = dice_.pick(keys);
        remove(node(key), "{" + std::to_string(key) + "}");
    }
    void remove_a_property() {
        const std::vector<int> keys = keys_of(values_, "properties");
        if (keys.size() < 2) return;
        const int key = dice_.pick(keys);
        remove(property(key), "{p" + std::to_string(key) + "}");
    }
    void rename_a_node() { values_[node(dice_.pick(keys_of(values_, "nodes"))) + "/id"] = free_name("n"); }
    void rename_a_property() {
        values_[property(dice_.pick(keys_of(values_, "properties"))) + "/name"] = free_name("_P");
    }
    void change_a_property() {
        const std::string path = property(dice_.pick(keys_of(values_, "properties")));
        const bool is_color = values_[path + "/type"] == "\"color\"";
        if (dice_.chance(50)) {
            values_[path + "/label"] = quoted("label " + std::to_string(dice_.below(5)));
        } else if (is_color) {
            values_[path + "/default"] = quoted(dice_.chance(50) ? "#ff8800" : "#208040");
        } else if (dice_.chance(70)) {
            values_[path + "/default"] = "0." + std::to_string(1 + dice_.below(9));
        } else {
            values_[path + "/range"] = dice_.chance(50) ? "[0, 1]" : "[0, 2]";
        }
    }
    void rewrite_a_node() { content(dice_.pick(keys_of(values_, "nodes"))); }
    void change_render() {
        values_["render"] = "";
        if (dice_.chance(50)) {
            values_["render/cull"] = quoted(dice_.chance(50) ? "off" : "front");
        } else {
            values_["render/queue"] = std::to_string(2000 + dice_.below(4));
        }
    }
    void swap_properties() {
        const std::vector<int> keys = keys_of(values_, "properties");
        std::swap(values_[property(dice_.pick(keys)) + "/@place"], values_[property(dice_.pick(keys)) + "/@place"]);
    }
    void change_meta() {
        values_["meta"] = "";
        values_["meta/" + std::string(1, "abc"[dice_.below(3)])] = std::to_string(dice_.below(5));
    }

    Values& values_;
    Dice& dice_;
    int next_key_;
    std::set<std::string> used_{};
};

}  // namespace patina
