# Tepui. `make install PREFIX=/usr/local` puts libOSMesa.so.8, the headers and osmesa.pc in place.

PREFIX ?= /usr/local
LIBDIR ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
DESTDIR ?=
CARGO ?= cargo
VERSION := $(shell sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml | head -n 1)
# The API of Mesa 11.2 under the SONAME libOSMesa.so.8; ours is the version after it.
LIBRARY := libOSMesa.so.8.$(VERSION)

.PHONY: all install

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
