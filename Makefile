# Tepui.
#   make demo      builds the library, draws a picture with it and says where it is: needs Rust and gcc, nothing else
#   make check     tests, and the comparison with Mesa's OSMesa on the CPU executor and on the kernels
#   make install   PREFIX=/usr/local: libOSMesa.so.8, the headers and osmesa.pc
#   make examples  every example against Tepui; make examples-osmesa: the same sources against Mesa's OSMesa

PREFIX ?= /usr/local
LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DESTDIR ?=
CARGO ?= cargo
VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
# The API of Mesa 11.2 under the SONAME libOSMesa.so.8; ours is the version after it.
LIBRARY := libOSMesa.so.8.$(VERSION)

.PHONY: all install demo examples examples-osmesa check check-needs

all:
	$(CARGO) build --release -p tepui-capi

install: all
	install -d "$(DESTDIR)$(LIBDIR)/pkgconfig" "$(DESTDIR)$(INCLUDEDIR)/GL"
	install -m 755 target/release/libOSMesa.so "$(DESTDIR)$(LIBDIR)/$(LIBRARY)"
	ln -sf $(LIBRARY) "$(DESTDIR)$(LIBDIR)/libOSMesa.so.8"
	ln -sf libOSMesa.so.8 "$(DESTDIR)$(LIBDIR)/libOSMesa.so"
	install -m 644 include/GL/gl.h include/GL/glext.h include/GL/osmesa.h "$(DESTDIR)$(INCLUDEDIR)/GL"
	sed -e 's|@PREFIX@|$(PREFIX)|; s|@LIBDIR@|$(LIBDIR)|; s|@INCLUDEDIR@|$(INCLUDEDIR)|' capi/osmesa.pc.in \
		> "$(DESTDIR)$(LIBDIR)/pkgconfig/osmesa.pc"

# Tepui's library under the names that programs ask for, for use without installing.
LIB := target/lib
EXAMPLES := $(patsubst examples/c/%.c,%,$(wildcard examples/c/*.c))
CFLAGS ?= -O2
EXAMPLE_FLAGS := -std=gnu11 $(CFLAGS) -Wall -Wextra

$(LIB)/libOSMesa.so.8: | all
	@mkdir -p $(LIB)
	@ln -sf ../release/libOSMesa.so $(LIB)/libOSMesa.so
	@ln -sf ../release/libOSMesa.so $(LIB)/libOSMesa.so.8

target/examples/%: examples/c/%.c examples/c/offscreen.h | $(LIB)/libOSMesa.so.8
	@mkdir -p target/examples
	$(CC) $(EXAMPLE_FLAGS) -I include $< -o $@ -L $(LIB) -Wl,-rpath,$(CURDIR)/$(LIB) -lOSMesa -lm

target/examples-osmesa/%: examples/c/%.c examples/c/offscreen.h
	@mkdir -p target/examples-osmesa
	$(CC) $(EXAMPLE_FLAGS) $< -o $@ -lOSMesa -lm

examples: $(EXAMPLES:%=target/examples/%)

examples-osmesa: $(EXAMPLES:%=target/examples-osmesa/%)

demo: target/examples/teapot
	@mkdir -p demo
	cd demo && TEPUI_DEVICE=cpu ../target/examples/teapot
	@echo "Tepui drew $(CURDIR)/demo/teapot.png"

# What the comparison needs beyond Rust and gcc: the reference, a software Vulkan for the kernels, and a mesh.
NEEDS := libosmesa6 libosmesa6-dev mesa-vulkan-drivers libvulkan1 glmark2-data

check-needs:
	@missing=""; for p in $(NEEDS); do dpkg -s $$p >/dev/null 2>&1 || missing="$$missing $$p"; done; \
	if [ -n "$$missing" ]; then \
		echo "installing$$missing"; sudo=""; [ "$$(id -u)" = 0 ] || sudo="sudo -n"; \
		$$sudo apt-get update -qq && $$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $$missing >/dev/null || \
		{ echo "make check needs the packages$$missing and could not install them; as root: apt-get install$$missing"; exit 1; }; \
	fi

check: check-needs examples examples-osmesa
	./conformance/check.sh
