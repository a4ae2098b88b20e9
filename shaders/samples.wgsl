            // One pixel of several samples: coverage, depth and stencil by sample, colour once, at the centre. The twin of
            // src/raster/samples.rs. A bit a sample in all masks.
            let y = f32(py) + to_centre;
            var wanted = allowed;
//#if REJECTS
            // A pixel all of whose samples are nearer than the triangle is passed by.
//#if OFFSET
            let nearest = tp_fma(y, p2, tp_fma(x, p1, p0)) + p6 - depth_slack;
//#else
            let nearest = tp_fma(y, p2, tp_fma(x, p1, p0)) - depth_slack;
//#endif
            wanted = wanted && tp_quantise(state, nearest) <= tp_furthest[r] + 1u;
//#endif
//#if REJECTS_LATE
            {
//#else
            if (wanted) {
//#endif
            var cover = 0u;
//#each $
            {
                let at = e + edge_$;
                cover |= select(0u, 1u << $u, (at.x | at.y | at.z) >= 0);
            }
//#end
//#if DROPS_SAMPLES
            cover &= ~WORD(sb, 6);
//#endif
//#if REJECTS_LATE
            cover = select(0u, cover, wanted);
//#endif
            if (cover != 0u) {
                //#insert DEPTH
//#if DEPTH_BUFFER
//#each $
                let old_$ = tp_depths[r * i32(TP_SAMPLES) + $];
//#end
//#endif
//#if STENCIL_TEST
                var stencil_pass = 0u;
//#each $
                stencil_pass |= select(0u, 1u << $u, tp_stencil_test(state, old_$ >> 24u));
//#end
//#else
                const stencil_pass = 0xffffffffu;
//#endif
//#if SAMPLE_DEPTH
                var depth_pass = 0u;
//#each $
//#if OFFSET
                let depth_$ = tp_quantise(state, tp_fma(y + zy_$, p2, zx_$) + p6);
//#else
                let depth_$ = tp_quantise(state, tp_fma(y + zy_$, p2, zx_$));
//#endif
                depth_pass |= select(0u, 1u << $u, tp_depth_test(state, depth_$, old_$ & TP_DEPTH_MASK));
//#end
//#else
//#if WRITES_DEPTH
                var depth_pass = 0xffffffffu;
//#else
                const depth_pass = 0xffffffffu;
//#endif
//#endif
                var keep = true;
                var color = vec4<f32>(0.0);
//#if WRITES_DEPTH
                var program_depth = 0.0;
//#endif
//#if SHADES
//#if NEEDS_KILL_FIRST
                {
//#else
                if ((cover & stencil_pass & depth_pass) != 0u) {
//#endif
                    //#insert SHADE
                }
//#endif
//#if ALPHA_TO_COVERAGE
                if ((state.flags & TP_ALPHA_TO_COVERAGE_ON) != 0u) {
                    let alpha = bitcast<u32>(tp_mul(min(max(color.w, 0.0), 1.0), 255.0) + 8388608.0) & 255u;
//#each $
                    cover &= ~select(1u << $u, 0u, alpha > 255u * $u / TP_SAMPLES);
//#end
                }
//#endif
//#if ALPHA_TEST
                keep = keep && tp_alpha_test(state, color.w);
//#endif
//#if ALPHA_TO_ONE
                color.w = select(color.w, 1.0, (state.flags & TP_ALPHA_TO_ONE_ON) != 0u);
//#endif
                cover = select(0u, cover, keep);
//#if WRITES_DEPTH
                let depth = tp_quantise(state, program_depth);
                depth_pass = 0u;
//#each $
                depth_pass |= select(0u, 1u << $u, tp_depth_test(state, depth, old_$ & TP_DEPTH_MASK));
//#end
//#endif
                let passes = cover & stencil_pass & depth_pass;
//#each $
//#if DEPTH_BUFFER
                {
                    var fresh = old_$;
//#if STENCIL_TEST
                    let stencil = tp_stencil_update(
                        state, old_$ >> 24u, (stencil_pass & (1u << $u)) != 0u, (depth_pass & (1u << $u)) != 0u);
                    fresh = select(fresh, (fresh & 0xffffffu) | (stencil << 24u), (cover & (1u << $u)) != 0u);
//#endif
//#if DEPTH_WRITE
                    let writes = (passes & (1u << $u)) != 0u && (state.flags & TP_DEPTH_WRITE_ON) == TP_DEPTH_WRITE_ON;
//#if WRITES_DEPTH
                    fresh = select(fresh, (fresh & ~TP_DEPTH_MASK) | depth, writes);
//#else
                    fresh = select(fresh, (fresh & ~TP_DEPTH_MASK) | depth_$, writes);
//#endif
//#endif
                    tp_depths[r * i32(TP_SAMPLES) + $] = fresh;
                }
//#endif
//#if COLOR_WRITE
                {
                    // No branch, so that what samples have in common is computed once.
                    let old = tp_pixels[r * i32(TP_SAMPLES) + $];
                    tp_pixels[r * i32(TP_SAMPLES) + $] = select(old, tp_merge(state, old, color), (passes & (1u << $u)) != 0u);
                }
//#endif
//#end
//#if REJECTS
                tp_furthest[r] = 0u;
//#each $
                tp_furthest[r] = max(tp_furthest[r], tp_depths[r * i32(TP_SAMPLES) + $] & TP_DEPTH_MASK);
//#end
//#endif
                dirty |= 1u << u32(r);
            }
            }
