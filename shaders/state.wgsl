        // Words of a draw as src/device/gpu/records.rs packs them.
//#if STATE_FLAGS
        state.flags = WORD(sa, 2);
//#else
        // What the kernel contains is on in every draw.
        state.flags = 0xffffffffu;
//#endif
//#if MIXED_INTERPOLATION
        let modes = WORD(sa, 2) >> 16u;
//#endif
        let functions = WORD(sa, 3);
//#if DEPTH_FUNC_FIXED
        state.depth_func = TP_DEPTH_FUNC;
//#else
        state.depth_func = functions & 7u;
//#endif
        state.alpha_func = (functions >> 8u) & 7u;
        state.logic_op = (functions >> 16u) & 15u;
        state.color_mask = functions >> 24u;
        state.depth_range = vec2<f32>(bitcast<f32>(WORD(sa, 4)), bitcast<f32>(WORD(sa, 5)));
        state.alpha_ref = WORD(sa, 6);
        state.stipple = WORD(sa, 7);
//#if BLEND_DYNAMIC
        let factors = WORD(sb, 0);
        state.factors = vec4<u32>(factors & 255u, (factors >> 8u) & 255u, (factors >> 16u) & 255u, factors >> 24u);
        state.equations = vec2<u32>(WORD(sb, 1) & 255u, WORD(sb, 1) >> 8u);
//#endif
//#if BLEND_CONSTANT
        state.blend_color = bitcast<vec4<f32>>(vec4<u32>(WORD(sb, 2), WORD(sb, 3), WORD(sb, 4), WORD(sb, 5)));
//#endif
//#if STENCIL_TEST
        state.stencil_func = WORD(sc, 0);
        state.stencil_ref = WORD(sc, 1);
        state.stencil_read = WORD(sc, 2);
        state.stencil_write = WORD(sc, 3);
        state.stencil_ops = vec3<u32>(WORD(sc, 4), WORD(sc, 5), WORD(sc, 6));
//#endif
