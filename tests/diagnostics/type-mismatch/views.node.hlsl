struct Layer { Texture2D map; float weight; };

Texture2D Same(Texture2D map) { return map; }

/// A function's result and a struct's member are textures as their files have them.
[node("Test/Views")]
float4 Views(Texture2D map, float2 uv = uv0) {
    Layer layer;
    layer.map = map;
    return Same(map).Sample(uv) + layer.map.Sample(uv);
}
