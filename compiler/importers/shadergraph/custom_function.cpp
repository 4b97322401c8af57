// Nodes with code of their own.
#include "compiler/importers/shadergraph/graph_maker.h"

namespace patina::importers::shadergraph {

void make_custom_function(GraphMaker& maker, std::size_t node) {
    maker.refuse(node, "code of custom functions is not imported");
}

}  // namespace patina::importers::shadergraph
