[pass("alone")] [fragment]
float4 aloneFragment() {
    return float4(1);
}
[pass("lonely")] [vertex]
float4 lonelyVertex(float3 position = positionWS) {
    return float4(position, 1);
}
[pass("both")] [vertex] [fragment]
float4 both(float3 position = positionWS) {
    return float4(position, 1);
}
[pass("../elsewhere")] [vertex]
float4 elsewhereVertex(float3 position = positionWS) {
    return float4(position, 1);
}
[pass("../elsewhere")] [fragment] [fallback("stages")]
float4 elsewhereFragment() {
    return float4(1);
}
