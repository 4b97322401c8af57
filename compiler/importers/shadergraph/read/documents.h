// The text of a .shadergraph or .shadersubgraph file as JSON trees, each of whose values knows its place in the file.
// It knows two layouts and no key of a node:
//
//   new: several objects one after another, each with "m_Type" and "m_ObjectId"
//   old: one object, whose elements hold further JSON in strings ("JSONnodeData")
//
//   Documents documents = read_documents("x.shadergraph", text);
//   if (!documents.error.empty()) ...                  // "x.shadergraph:3:9: ..."
//   for (const json::Json* root : documents.roots) ...
//   const json::Json* inner = documents.inner(*string);  // of the old layout
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/json/json.h"

namespace patina::importers::shadergraph {

using json::Json;

struct Place {
    int line = 0;    // from 1; 0: nowhere
    int column = 0;  // from 1, in bytes
};

class Documents {
public:
    std::string error{};  // not empty: the file cannot be read, "x.shadergraph:3:9: ..."
    std::vector<const Json*> roots{};

    // The JSON in a string of the file, or null if it is none. Parsed once.
    const Json* inner(const Json& string);
    // Where the value is in the file.
    Place place(const Json& value) const;
    const std::string& path() const { return path_; }

private:
    friend Documents read_documents(const std::string& path, std::string text);
    struct Piece {  // a text of its own in `sources_`
        std::uint32_t size = 0;
        int lines_before = 0;                  // in the file
        std::vector<std::uint32_t> offsets{};  // if it lay in a string: where each byte is
        std::uint32_t string_begin = 0;
    };
    const Json* parse(std::string_view text, Piece piece, std::string& wrong);
    Place resolve(std::uint32_t offset) const;

    std::string path_;
    std::unique_ptr<std::string> text_{};
    std::unique_ptr<SourceMap> sources_ = std::make_unique<SourceMap>();
    std::map<std::uint32_t, Piece> pieces_{};  // by their first byte
    std::vector<std::unique_ptr<Json>> trees_{};
    std::map<const Json*, const Json*> inner_{};
    std::size_t inner_bytes_ = 0;
};

Documents read_documents(const std::string& path, std::string text);

// --- members of an object, or what stands for them: a null object has none. If a member is there and cannot be taken,
// that is noted (misreads.h).

const Json* member(const Json* object, std::string_view path);  // "m_Conversion.from"
std::string_view text_of(const Json* object, std::string_view path);
double number_of(const Json* object, std::string_view path, double otherwise = 0);  // also of true and false
int whole_of(const Json* object, std::string_view path, int otherwise = 0);         // within +-2^31
int whole_in(const Json* object, std::string_view path, int otherwise, int low, int high);
int id_of(const Json* object, std::string_view path);  // one that cannot be taken makes the graph unknown
bool flag_of(const Json* object, std::string_view path, bool otherwise = false);
const std::vector<Json>& elements_of(const Json* object, std::string_view path);
// The components x, y, z, w or r, g, b, a of an object; missing ones are 0.
std::vector<double> vector_of(const Json* object, std::string_view path, std::size_t count);

}  // namespace patina::importers::shadergraph
