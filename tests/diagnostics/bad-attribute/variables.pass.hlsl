[reads("depth")] float depthNumber;
[reads] Texture2D ofNothing;
[extern] float ofNoBlock;
[extern("Frame")] Light noNumber;
[extern("Material")] float ofTheMaterial;
[static("surface", "cutout")] float noAnswer;
[static] bool noQuestion;
[switch] int manyWays;
[attribute] float4 ofNoMesh;
[given] float4 ofNoGraph;

[pass("mine")] [vertex]
float4 mineVertex(float3 position = positionWS) {
    return mul(worldToClip, float4(position, 1));
}
[pass("mine")] [fragment]
float4 mineFragment(float3 position = positionWS) {
    return float4(litByAll(lightingSurface(), position), 1);
}
