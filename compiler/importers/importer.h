// The room `importers` turns materials of other programs into graph files. It needs no GPU.
//
// The seam for importers. This folder holds this interface, the list of importers (importers.cpp), imported_graph.h
// with terms.h and patterns.h, which all of them make graphs with, and the folder unity/, which those of Unity's
// formats share. To add one: write a folder with a function that returns its row, and add the row to the list. No other
// file names a format.
//
// An importer reads the file that it is given and the files that this one names. It draws nothing and writes nothing:
// `patina import` writes what it returns, all or nothing. Whatever it does not carry over is a remark; nothing is
// dropped silently.
//
//   const Source source = {.path = "gold-paint.binary", .start = first_bytes};
//   if (const Importer* importer = importer_of(source)) Imported made = read_verified(*importer, source, {});
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/picture/image.h"

namespace patina::importers {

struct Source {
    std::string path;
    std::string start;  // the first bytes of the file, kStart of them if it has so many: for recognises()
};
inline constexpr std::size_t kStart = 4096;

struct Options {
    std::string name{};    // of the graph; empty: the name of the file
    std::string folder{};  // that the files will be written to, for references to others; empty: the source's own
    std::string camera{};  // of a source with a scene: the camera that it is seen through; empty: the first
    std::vector<std::string> include_dirs{};  // folders that are searched for files that the source names
    std::string variant{};  // the one of its variants that the scene shows; empty: each has a scene of its own
    bool is_lit = false;    // what the scene is drawn in has light: without lights of its own, it needs no others
};

// What became of one part of the source.
struct Remark {
    enum class Kind {
        Taken,    // the graph says the same
        Changed,  // the graph says nearly the same
        LeftOut   // the graph does not say it; `patina import` warns
    };
    Kind kind = Kind::Taken;
    std::string part;    // as the source names it: "materials[2].emissiveFactor"
    std::string text;    // what it became, or why it is left out: "the input 'emission'"
    int line = 0;        // in the file, from 1; 0: a binary file, or the file as a whole
    int column = 0;      // from 1, in bytes
    std::string file{};  // empty: the source; else one that it uses: "Wood.shadersubgraph"
};
std::string_view to_string(Remark::Kind kind);  // "exact", "approximate", "refused"

// Files to write, named relative to the output folder.
struct TextFile {
    std::string name;  // "gold-paint.graph.json"
    std::string text;
};
struct BinaryFile {  // copied as it is: a texture that lies inside the source
    std::string name;
    std::string bytes;
};
struct PictureFile {
    std::string name;  // its ending is the format: .exr (values as they are) or .png (sRGB)
    runtime::Image linear;
};

struct Imported {
    std::string error{};  // not empty: what is wrong, with the file's name; then there is nothing else
    std::vector<TextFile> graphs{};
    std::string scene{};  // the one of the graphs that shows all; empty: there is none
    std::vector<PictureFile> pictures{};
    std::vector<BinaryFile> copies{};
    std::vector<Remark> remarks{};
    bool has_refused = false;  // the graphs show a constant in the place of what could not be imported
};

struct Importer {
    std::string_view name;      // "merl"
    std::string_view reads;     // for --help: "measured BRDFs of the MERL database (.binary)"
    std::string_view example;   // for --help: "patina import gold-paint.binary"
    bool makes_pictures;        // if it returns none, `patina import` need not load OpenImageIO
    bool keeps_report = false;  // `patina import` writes the remarks as NAME.import.json, too
    bool (*recognises)(const Source& source);
    Imported (*read)(const Source& source, const Options& options);
};

// What the importer makes of the source, if the compiler reads all graphs and scenes of it without an error; else the
// error.
Imported read_verified(const Importer& importer, const Source& source, const Options& options);

std::span<const Importer> importers();
// The first that recognises the source, or null.
const Importer* importer_of(const Source& source);

}  // namespace patina::importers
