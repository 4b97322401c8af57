// A picture that is drawn tile by tile, in little memory: render targets have the size of a tile, and everything else
// still sees the whole picture. A function with [wraps] is put around what every pass of the camera has of that kind.

/// The picture is drawn tile by tile: render targets hold only a part of it.
[switch] bool tiles;
/// xy: the pixel of the picture at the upper left corner of the targets; zw: their size.
/// unit: pixels
/// space: screen
[extern("Frame")] [with("tiles")] float4 tile;
/// Scale (xy) and offset (zw) of clip space, where a viewport that is as large as the picture is too large for the
/// device; else 1, 1, 0, 0.
/// space: clip
[extern("Frame")] [with("tiles")] float4 tileClip;

/// The position of a vertex in the clip space of the viewport.
[wraps("position")] [with("tiles")]
float4 positionInTile(float4 position) {
    if (!tiles) { return position; }
    return float4(position.xy * tileClip.xy + position.w * tileClip.zw, position.zw);
}

/// The place of a pixel in the picture.
[wraps("fragCoord")] [with("tiles")]
float4 pixelOfPicture(float4 pixel) {
    if (!tiles) { return pixel; }
    return float4(pixel.xy + tile.xy, pixel.zw);
}

/// Where a render target holds what the picture shows at `uv`. The default is the pixel itself: a pass that reads
/// another pixel needs the whole picture.
[wraps("reads")] [with("tiles")]
float2 placeInTile(float2 uv = screenUV) {
    if (!tiles) { return uv; }
    float2 fromTop = uvFromBottom ? float2(uv.x, 1 - uv.y) : uv;
    float2 place = (fromTop * screenSize - tile.xy) / tile.zw;
    return uvFromBottom ? float2(place.x, 1 - place.y) : place;
}
