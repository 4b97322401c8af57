/// Calls a stage of the library's forward path.
[pass("again")] [vertex]
float4 againVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("again")] [fragment]
float4 againFragment(float3 position = positionWS) {
    return forwardFragment(position);
}
