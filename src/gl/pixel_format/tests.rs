use super::*;

const COLOR_FORMATS: [GLenum; 11] =
    [GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_RGB, GL_BGR, GL_RGBA, GL_BGRA, GL_ABGR_EXT];
const PLAIN_TYPES: [GLenum; 7] = [GL_UNSIGNED_BYTE, GL_BYTE, GL_UNSIGNED_SHORT, GL_SHORT, GL_UNSIGNED_INT, GL_INT, GL_FLOAT];
const PACKED_TYPES: [GLenum; 12] = [
    GL_UNSIGNED_BYTE_3_3_2,
    GL_UNSIGNED_BYTE_2_3_3_REV,
    GL_UNSIGNED_SHORT_5_6_5,
    GL_UNSIGNED_SHORT_5_6_5_REV,
    GL_UNSIGNED_SHORT_4_4_4_4,
    GL_UNSIGNED_SHORT_4_4_4_4_REV,
    GL_UNSIGNED_SHORT_5_5_5_1,
    GL_UNSIGNED_SHORT_1_5_5_5_REV,
    GL_UNSIGNED_INT_8_8_8_8,
    GL_UNSIGNED_INT_8_8_8_8_REV,
    GL_UNSIGNED_INT_10_10_10_2,
    GL_UNSIGNED_INT_2_10_10_10_REV,
];

fn as_floats(groups: Groups) -> Vec<[f32; 4]> {
    match groups {
        Groups::Rgba8(p) => p.iter().map(|p| p.to_le_bytes().map(|c| c as f32 / 255.0)).collect(),
        Groups::Rgba(p) => p,
        _ => panic!("no colours"),
    }
}

/// Packs zeros and ones in every component, which every type holds exactly, and unpacks them again.
fn round_trip(store: &PixelStore, format: GLenum, ty: GLenum) {
    let size = [3usize, 5, 2];
    let pixels: Vec<[f32; 4]> = (0..30).map(|i| std::array::from_fn(|k| (i >> k & 1) as f32)).collect();
    let wanted: Vec<[f32; 4]> = pixels
        .iter()
        .map(|&[r, g, b, a]| match format {
            GL_RED => [r, 0.0, 0.0, 1.0],
            GL_GREEN => [0.0, g, 0.0, 1.0],
            GL_BLUE => [0.0, 0.0, b, 1.0],
            GL_ALPHA => [0.0, 0.0, 0.0, a],
            GL_LUMINANCE => [(r + g + b).min(1.0), (r + g + b).min(1.0), (r + g + b).min(1.0), 1.0],
            GL_LUMINANCE_ALPHA => [(r + g + b).min(1.0), (r + g + b).min(1.0), (r + g + b).min(1.0), a],
            GL_RGB | GL_BGR => [r, g, b, 1.0],
            _ => [r, g, b, a],
        })
        .collect();
    let isize = size.map(|n| n as i32);
    let end = store.layout(isize, true, format, ty).unwrap().end;
    for rgba8 in [false, true] {
        let groups = if rgba8 {
            Groups::Rgba8(pixels.iter().map(|p| u32::from_le_bytes(p.map(|c| (c * 255.0) as u8))).collect())
        } else {
            Groups::Rgba(pixels.clone())
        };
        let mut bytes = vec![0xa5; end];
        pack(store, &mut bytes, size, true, format, ty, &groups);
        let image = ClientImage::unpack(store, &bytes, isize, true, format, ty).unwrap();
        assert_eq!(as_floats(image.groups), wanted, "{format:#x} {ty:#x} from 8 bits: {rgba8}");
    }
}

#[test]
fn every_colour_format_and_type_survives_a_round_trip() {
    let plain = PixelStore::default();
    let odd = PixelStore {
        swap_bytes: true,
        row_length: 7,
        skip_rows: 1,
        skip_pixels: 3,
        skip_images: 1,
        image_height: 6,
        alignment: 8,
        ..plain.clone()
    };
    for store in [plain, odd] {
        for format in COLOR_FORMATS {
            for ty in PLAIN_TYPES.into_iter().chain(PACKED_TYPES) {
                if check(format, ty).is_ok() {
                    round_trip(&store, format, ty);
                }
            }
        }
    }
}

#[test]
fn every_byte_value_survives_every_plain_type() {
    let pixels: Vec<u32> = (0..256u32).map(|i| i | (255 - i) << 8 | (i ^ 0x55) << 16 | (i ^ 0xaa) << 24).collect();
    let store = PixelStore::default();
    for ty in [
        GL_UNSIGNED_BYTE,
        GL_UNSIGNED_SHORT,
        GL_SHORT,
        GL_UNSIGNED_INT,
        GL_INT,
        GL_FLOAT,
        GL_UNSIGNED_INT_8_8_8_8,
        GL_UNSIGNED_INT_10_10_10_2,
    ] {
        let mut bytes = vec![0; 256 * 16];
        pack(&store, &mut bytes, [256, 1, 1], false, GL_RGBA, ty, &Groups::Rgba8(pixels.clone()));
        let image = ClientImage::unpack(&store, &bytes, [256, 1, 1], false, GL_RGBA, ty).unwrap();
        let back: Vec<u32> = as_floats(image.groups).iter().map(|p| u32::from_le_bytes(p.map(|c| (c * 255.0).round() as u8))).collect();
        let mask = if ty == GL_UNSIGNED_INT_10_10_10_2 { 0xff_ffff } else { !0 };
        assert!(back.iter().zip(&pixels).all(|(a, b)| a & mask == b & mask), "{ty:#x}");
    }
}

#[test]
fn indices_and_depths_survive_a_round_trip() {
    for store in [PixelStore::default(), PixelStore { lsb_first: true, skip_pixels: 5, swap_bytes: true, ..PixelStore::default() }] {
        for ty in PLAIN_TYPES.into_iter().chain([GL_BITMAP]) {
            let mask = if ty == GL_BITMAP { 1 } else { 0x7f };
            let values: Vec<u32> = (0..77u32).map(|i| (i * 29) & mask).collect();
            let end = store.layout([11, 7, 1], false, GL_STENCIL_INDEX, ty).unwrap().end;
            let mut bytes = vec![0; end];
            pack(&store, &mut bytes, [11, 7, 1], false, GL_STENCIL_INDEX, ty, &Groups::Index(values.clone()));
            let image = ClientImage::unpack(&store, &bytes, [11, 7, 1], false, GL_STENCIL_INDEX, ty).unwrap();
            assert_eq!(image.groups, Groups::Index(values), "{ty:#x}");
        }
        for ty in PLAIN_TYPES {
            let values: Vec<f64> = vec![0.0, 1.0, 1.0, 0.0];
            let mut bytes = vec![0; 64];
            pack(&store, &mut bytes, [4, 1, 1], false, GL_DEPTH_COMPONENT, ty, &Groups::Depth(values.clone()));
            let image = ClientImage::unpack(&store, &bytes, [4, 1, 1], false, GL_DEPTH_COMPONENT, ty).unwrap();
            assert_eq!(image.groups, Groups::Depth(values), "{ty:#x}");
        }
    }
}

#[test]
fn packed_types_have_their_first_component_where_the_specification_puts_it() {
    let store = PixelStore::default();
    let red = Groups::Rgba(vec![[1.0, 0.0, 0.0, 0.0]]);
    let word = |format, ty, bytes: usize| {
        let mut out = vec![0; bytes];
        pack(&store, &mut out, [1, 1, 1], false, format, ty, &red);
        out.resize(4, 0);
        u32::from_ne_bytes([out[0], out[1], out[2], out[3]])
    };
    assert_eq!(word(GL_RGB, GL_UNSIGNED_BYTE_3_3_2, 1), 0xe0);
    assert_eq!(word(GL_RGB, GL_UNSIGNED_BYTE_2_3_3_REV, 1), 0x07);
    assert_eq!(word(GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2), 0xf800);
    assert_eq!(word(GL_RGBA, GL_UNSIGNED_SHORT_1_5_5_5_REV, 2), 0x001f);
    assert_eq!(word(GL_BGRA, GL_UNSIGNED_SHORT_1_5_5_5_REV, 2), 0x7c00);
    assert_eq!(word(GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, 4), 0xff00_0000);
    assert_eq!(word(GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, 4), 0x00ff_0000);
    assert_eq!(word(GL_RGBA, GL_UNSIGNED_INT_10_10_10_2, 4), 0xffc0_0000);
}

#[test]
fn bad_combinations_are_named() {
    assert_eq!(check(GL_RGB, GL_UNSIGNED_SHORT_4_4_4_4), Err(GL_INVALID_OPERATION));
    assert_eq!(check(GL_BGR, GL_UNSIGNED_SHORT_5_6_5), Err(GL_INVALID_OPERATION));
    assert_eq!(check(GL_RGBA, GL_UNSIGNED_BYTE_3_3_2), Err(GL_INVALID_OPERATION));
    assert_eq!(check(GL_RGBA, GL_BITMAP), Err(GL_INVALID_ENUM));
    assert_eq!(check(GL_COLOR_INDEX, GL_BITMAP), Ok(()));
    assert_eq!(check(GL_RGBA8, GL_UNSIGNED_BYTE), Err(GL_INVALID_ENUM));
    assert_eq!(check(GL_RGBA, GL_DOUBLE), Err(GL_INVALID_ENUM));
}

#[test]
fn bytes_that_do_not_reach_are_not_read() {
    assert_eq!(ClientImage::unpack(&PixelStore::default(), &[0; 15], [2, 2, 1], false, GL_RGBA, GL_UNSIGNED_BYTE), None);
}
