[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment] [draws("object")] [each("lights")] [lights("mains")] [camera("orthographic")]
[cull("none")] [blend("opake", "one", "zeros")] [depth("lessequal", "read")] [stencil("equals", "replce", "1")]
[fallback("foward")] [lacks("tiem", "fixedTime")] [target("color", "rgba16")]
float4 mineFragment() {
    return float4(1);
}
