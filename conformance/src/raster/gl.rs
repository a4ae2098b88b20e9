//! OpenGL, OSMesa and EGL as tables of functions, loaded when the program runs: one program serves every implementation.
//!
//! The only `unsafe` of the harness is here and in its callers `client.rs` and `target.rs`: this is the C border from the other side.

use std::ffi::{CStr, CString, c_char, c_int, c_void};

use libloading::os::unix::{Library, RTLD_LOCAL, RTLD_NOW};

/// A table of functions; each is looked up by its C name.
macro_rules! functions {
    ($(#[$about:meta])* $table:ident { $($field:ident: $name:ident($($a:ty),*) $(-> $r:ty)?;)* }) => {
        $(#[$about])*
        #[allow(missing_docs)]
        pub struct $table { $(pub $field: unsafe extern "C" fn($($a),*) $(-> $r)?,)* }

        impl $table {
            /// The table, or the name of the first function that is not there.
            pub fn load(find: &dyn Fn(&str) -> *const c_void) -> Result<$table, String> {
                $(let $field = find(stringify!($name));
                if $field.is_null() {
                    return Err(format!("there is no {}", stringify!($name)));
                })*
                // SAFETY: the functions have the types of the headers (gl.h, glext.h, osmesa.h, egl.h); null was left out above.
                Ok($table { $($field: unsafe { std::mem::transmute::<*const c_void, unsafe extern "C" fn($($a),*) $(-> $r)?>($field) },)* })
            }
        }
    };
}

functions! {
    /// What every scene needs.
    Gl {
        get_string: glGetString(u32) -> *const c_char;
        get_integer: glGetIntegerv(u32, *mut c_int);
        get_error: glGetError() -> u32;
        viewport: glViewport(c_int, c_int, c_int, c_int);
        clear_color: glClearColor(f32, f32, f32, f32);
        clear: glClear(u32);
        enable: glEnable(u32);
        disable: glDisable(u32);
        depth_func: glDepthFunc(u32);
        blend_func: glBlendFunc(u32, u32);
        color_mask: glColorMask(u8, u8, u8, u8);
        shade_model: glShadeModel(u32);
        light_model: glLightModelfv(u32, *const f32);
        enable_client_state: glEnableClientState(u32);
        disable_client_state: glDisableClientState(u32);
        vertex_pointer: glVertexPointer(c_int, u32, c_int, *const c_void);
        color_pointer: glColorPointer(c_int, u32, c_int, *const c_void);
        tex_coord_pointer: glTexCoordPointer(c_int, u32, c_int, *const c_void);
        draw_elements: glDrawElements(u32, c_int, u32, *const c_void);
        tex_image: glTexImage2D(u32, c_int, c_int, c_int, c_int, c_int, u32, u32, *const c_void);
        tex_parameter: glTexParameteri(u32, u32, c_int);
        tex_env: glTexEnvi(u32, u32, c_int);
        read_pixels: glReadPixels(c_int, c_int, c_int, c_int, u32, u32, *mut c_void);
        finish: glFinish();
    }
}

functions! {
    /// Buffer objects (OpenGL 1.5).
    Buffers {
        generate: glGenBuffers(c_int, *mut u32);
        bind: glBindBuffer(u32, u32);
        data: glBufferData(u32, isize, *const c_void, u32);
    }
}

functions! {
    /// Framebuffer objects (ARB_framebuffer_object).
    Framebuffers {
        generate: glGenFramebuffers(c_int, *mut u32);
        bind: glBindFramebuffer(u32, u32);
        generate_buffers: glGenRenderbuffers(c_int, *mut u32);
        bind_buffer: glBindRenderbuffer(u32, u32);
        storage: glRenderbufferStorageMultisample(u32, c_int, u32, c_int, c_int);
        attach: glFramebufferRenderbuffer(u32, u32, u32, u32);
        status: glCheckFramebufferStatus(u32) -> u32;
        blit: glBlitFramebuffer(c_int, c_int, c_int, c_int, c_int, c_int, c_int, c_int, u32, u32);
    }
}

functions! {
    /// Time on the device (ARB_timer_query).
    Queries {
        generate: glGenQueries(c_int, *mut u32);
        begin: glBeginQuery(u32, u32);
        end: glEndQuery(u32);
        result: glGetQueryObjectui64v(u32, u32, *mut u64);
    }
}

functions! {
    /// Off-screen Mesa.
    OsMesa {
        create: OSMesaCreateContextExt(u32, c_int, c_int, c_int, *mut c_void) -> *mut c_void;
        make_current: OSMesaMakeCurrent(*mut c_void, *mut c_void, u32, c_int, c_int) -> u8;
        destroy: OSMesaDestroyContext(*mut c_void);
        find: OSMesaGetProcAddress(*const c_char) -> *const c_void;
    }
}

functions! {
    /// EGL.
    Egl {
        find: eglGetProcAddress(*const c_char) -> *const c_void;
        initialize: eglInitialize(*mut c_void, *mut c_int, *mut c_int) -> u32;
        bind_api: eglBindAPI(u32) -> u32;
        choose_config: eglChooseConfig(*mut c_void, *const c_int, *mut *mut c_void, c_int, *mut c_int) -> u32;
        create_context: eglCreateContext(*mut c_void, *mut c_void, *mut c_void, *const c_int) -> *mut c_void;
        make_current: eglMakeCurrent(*mut c_void, *mut c_void, *mut c_void, *mut c_void) -> u32;
    }
}

functions! {
    /// EGL without a display (EXT_device_enumeration, EXT_platform_base).
    EglPlatforms {
        devices: eglQueryDevicesEXT(c_int, *mut *mut c_void, *mut c_int) -> u32;
        display: eglGetPlatformDisplayEXT(u32, *mut c_void, *const c_int) -> *mut c_void;
    }
}

/// Opens a library that stays open: drivers do not like to be closed.
pub fn open(path: &str) -> Result<&'static Library, String> {
    // SAFETY: loading runs the library's initialisers; it is an OpenGL driver that the user has named.
    let library = unsafe { Library::open(Some(path), RTLD_NOW | RTLD_LOCAL) };
    library.map(|l| &*Box::leak(Box::new(l))).map_err(|e| format!("{path}: {e}"))
}

/// The address of a symbol of a library, null without one.
pub fn symbol(library: &Library, name: &str) -> *const c_void {
    // SAFETY: the address is only carried, not called.
    unsafe { library.get::<*const c_void>(name.as_bytes()) }.map_or(std::ptr::null(), |s| s.into_raw().cast_const().cast())
}

/// Asks a driver for the address of a function.
pub fn proc_address(find: unsafe extern "C" fn(*const c_char) -> *const c_void, name: &str) -> *const c_void {
    // SAFETY: a C string, as the function wants it.
    CString::new(name).map_or(std::ptr::null(), |name| unsafe { find(name.as_ptr()) })
}

impl Gl {
    /// One of the strings of glGetString.
    pub fn string(&self, name: u32) -> String {
        // SAFETY: a context is current; the string belongs to it and is copied.
        unsafe {
            let text = (self.get_string)(name);
            if text.is_null() { String::new() } else { CStr::from_ptr(text).to_string_lossy().into_owned() }
        }
    }

    /// One of the integers of glGetIntegerv.
    pub fn integer(&self, name: u32) -> i32 {
        // Some of them are more than one number.
        let mut values = [0; 16];
        // SAFETY: a context is current, and no name that is asked for has more than 16 values.
        unsafe { (self.get_integer)(name, values.as_mut_ptr()) };
        values[0]
    }
}

/// Numbers of gl.h, glext.h and egl.h.
#[allow(missing_docs)]
pub mod number {
    macro_rules! numbers { ($($name:ident = $value:expr;)*) => { $(pub const $name: u32 = $value;)* } }
    numbers! {
        TRIANGLES = 4; LESS = 0x201; SRC_ALPHA = 0x302; ONE_MINUS_SRC_ALPHA = 0x303;
        CULL_FACE = 0xB44; LIGHTING = 0xB50; LIGHT_MODEL_AMBIENT = 0xB53; COLOR_MATERIAL = 0xB57; DEPTH_TEST = 0xB71; BLEND = 0xBE2;
        TEXTURE_2D = 0xDE1; UNSIGNED_BYTE = 0x1401; UNSIGNED_INT = 0x1405; FLOAT = 0x1406; RGBA = 0x1908;
        FLAT = 0x1D00; SMOOTH = 0x1D01; VENDOR = 0x1F00; RENDERER = 0x1F01; VERSION = 0x1F02; MODULATE = 0x2100; TEXTURE_ENV_MODE = 0x2200;
        TEXTURE_ENV = 0x2300; LINEAR = 0x2601; TEXTURE_MAG_FILTER = 0x2800; TEXTURE_MIN_FILTER = 0x2801; COLOR_AND_DEPTH = 0x4100;
        RGBA8 = 0x8058; VERTEX_ARRAY = 0x8074; COLOR_ARRAY = 0x8076; TEXTURE_COORD_ARRAY = 0x8078; COLOR_BUFFER_BIT = 0x4000; NEAREST = 0x2600;
        ARRAY_BUFFER = 0x8892; ELEMENT_ARRAY_BUFFER = 0x8893; STATIC_DRAW = 0x88E4; QUERY_RESULT = 0x8866; TIME_ELAPSED = 0x88BF;
        DEPTH24_STENCIL8 = 0x88F0; READ_FRAMEBUFFER = 0x8CA8; DRAW_FRAMEBUFFER = 0x8CA9; FRAMEBUFFER_COMPLETE = 0x8CD5; COLOR_ATTACHMENT0 = 0x8CE0;
        DEPTH_STENCIL_ATTACHMENT = 0x821A; FRAMEBUFFER = 0x8D40; RENDERBUFFER = 0x8D41; MAX_SAMPLES = 0x8D57; SAMPLES = 0x80A9;
        EGL_OPENGL_API = 0x30A2; EGL_SURFACE_TYPE = 0x3033; EGL_PBUFFER_BIT = 1; EGL_RENDERABLE_TYPE = 0x3040; EGL_OPENGL_BIT = 8;
        EGL_NONE = 0x3038; EGL_PLATFORM_DEVICE = 0x313F; EGL_PLATFORM_SURFACELESS = 0x31DD;
    }
}
