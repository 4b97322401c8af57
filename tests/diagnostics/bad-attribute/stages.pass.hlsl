[pass("alone")] [fragment]
float4 alone_fragment() {
    return float4(1);
}
[pass("lonely")] [vertex]
float4 lonely_vertex(float3 position = position_ws) {
    return float4(position, 1);
}
[pass("both")] [vertex] [fragment]
float4 both(float3 position = position_ws) {
    return float4(position, 1);
}
[pass("../elsewhere")] [vertex]
float4 elsewhere_vertex(float3 position = position_ws) {
    return float4(position, 1);
}
[pass("../elsewhere")] [fragment] [fallback("stages")]
float4 elsewhere_fragment() {
    return float4(1);
}
