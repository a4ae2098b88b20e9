// Colour storage: a pixel as the fine stage holds it, and as words of the colour buffer.

//#if FLOAT_PIXELS
// Components from 0 to 255 in floats, as long as a tile is drawn: blending is then two fused operations a component.
alias TpPixel = vec4<f32>;
fn tp_pixel_of(words: vec4<u32>) -> TpPixel {
    let p = words.x;
    return vec4<f32>(vec4<u32>(p & 255u, (p >> 8u) & 255u, (p >> 16u) & 255u, p >> 24u));
}
fn tp_load_pixel(at: u32) -> TpPixel {
    return tp_pixel_of(vec4<u32>(tp_color[at]));
}
fn tp_store_pixel(at: u32, p: TpPixel) {
    let c = vec4<u32>(p);
    tp_color[at] = c.x | (c.y << 8u) | (c.z << 16u) | (c.w << 24u);
}
//#else
//#if COLOR_WORDS_1
alias TpPixel = u32;
fn tp_pixel_of(words: vec4<u32>) -> TpPixel {
    return words.x;
}
fn tp_load_pixel(at: u32) -> TpPixel {
    return tp_color[at];
}
fn tp_store_pixel(at: u32, p: TpPixel) {
    tp_color[at] = p;
}
//#endif
//#if COLOR_WORDS_2
alias TpPixel = vec2<u32>;
fn tp_pixel_of(words: vec4<u32>) -> TpPixel {
    return words.xy;
}
fn tp_load_pixel(at: u32) -> TpPixel {
    return vec2<u32>(tp_color[at * 2u], tp_color[at * 2u + 1u]);
}
fn tp_store_pixel(at: u32, p: TpPixel) {
    tp_color[at * 2u] = p.x;
    tp_color[at * 2u + 1u] = p.y;
}
//#endif
//#if COLOR_WORDS_4
alias TpPixel = vec4<u32>;
fn tp_pixel_of(words: vec4<u32>) -> TpPixel {
    return words;
}
fn tp_load_pixel(at: u32) -> TpPixel {
    return vec4<u32>(tp_color[at * 4u], tp_color[at * 4u + 1u], tp_color[at * 4u + 2u], tp_color[at * 4u + 3u]);
}
fn tp_store_pixel(at: u32, p: TpPixel) {
    tp_color[at * 4u] = p.x;
    tp_color[at * 4u + 1u] = p.y;
    tp_color[at * 4u + 2u] = p.z;
    tp_color[at * 4u + 3u] = p.w;
}
//#endif

// Components as unsigned integers (all formats but Rgba32f, whose components are the bits of floats).
//#if COLOR_RGBA8
const TP_COLOR_SCALE = vec4<f32>(255.0);
const TP_COLOR_MAX = vec4<u32>(255u);
fn tp_unpack(p: TpPixel) -> vec4<u32> {
    return vec4<u32>(p & 255u, (p >> 8u) & 255u, (p >> 16u) & 255u, p >> 24u);
}
fn tp_pack(c: vec4<u32>) -> TpPixel {
    return c.x | (c.y << 8u) | (c.z << 16u) | (c.w << 24u);
}
//#endif
//#if COLOR_RGBX8
const TP_COLOR_SCALE = vec4<f32>(255.0);
const TP_COLOR_MAX = vec4<u32>(255u);
fn tp_unpack(p: TpPixel) -> vec4<u32> {
    return vec4<u32>(p & 255u, (p >> 8u) & 255u, (p >> 16u) & 255u, 255u);
}
fn tp_pack(c: vec4<u32>) -> TpPixel {
    return c.x | (c.y << 8u) | (c.z << 16u) | 0xff000000u;
}
//#endif
//#if COLOR_RGB565
const TP_COLOR_SCALE = vec4<f32>(31.0, 63.0, 31.0, 255.0);
const TP_COLOR_MAX = vec4<u32>(31u, 63u, 31u, 255u);
fn tp_unpack(p: TpPixel) -> vec4<u32> {
    return vec4<u32>(p & 31u, (p >> 5u) & 63u, (p >> 11u) & 31u, 255u);
}
fn tp_pack(c: vec4<u32>) -> TpPixel {
    return c.x | (c.y << 5u) | (c.z << 11u);
}
//#endif
//#if COLOR_RGBA16
const TP_COLOR_SCALE = vec4<f32>(65535.0);
const TP_COLOR_MAX = vec4<u32>(65535u);
fn tp_unpack(p: TpPixel) -> vec4<u32> {
    return vec4<u32>(p.x & 0xffffu, p.x >> 16u, p.y & 0xffffu, p.y >> 16u);
}
fn tp_pack(c: vec4<u32>) -> TpPixel {
    return vec2<u32>(c.x | (c.y << 16u), c.z | (c.w << 16u));
}
//#endif
//#if COLOR_RGBA32F
fn tp_unpack(p: TpPixel) -> vec4<u32> {
    return p;
}
fn tp_pack(c: vec4<u32>) -> TpPixel {
    return c;
}
//#endif
//#endif
