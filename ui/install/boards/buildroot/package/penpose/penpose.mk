# This tree is a part of penpose's own.
PENPOSE_VERSION = local
PENPOSE_SITE = $(BR2_EXTERNAL_PENPOSE_PATH)/../../../..
PENPOSE_SITE_METHOD = local
PENPOSE_LICENSE = MIT
PENPOSE_LICENSE_FILES = LICENSE
PENPOSE_DEPENDENCIES = host-pkgconf cli11 draco glm jpeg libpng meshoptimizer pugixml tinygltf webp xxhash zlib

penpose_onoff = $(if $($(1)),ON,OFF)
# Man pages and completions are written by a program of the board, which this machine cannot run.
PENPOSE_CONF_OPTS = \
	-DPENPOSE_TESTS=OFF \
	-DPENPOSE_WERROR=OFF \
	-DPENPOSE_PAGES=OFF -DPENPOSE_SOUND=OFF -DPENPOSE_SPEECH=OFF -DPENPOSE_PORTAL=OFF -DPENPOSE_ADDON=OFF \
	-DPENPOSE_OPENMESH=OFF \
	-DPENPOSE_STATIC=$(call penpose_onoff,BR2_STATIC_LIBS) \
	-DPENPOSE_DEVICES=$(call penpose_onoff,BR2_PACKAGE_PENPOSE_DEVICES) \
	-DPENPOSE_LIBUSB=$(call penpose_onoff,BR2_PACKAGE_PENPOSE_LIBUSB) \
	-DPENPOSE_WINDOW=$(call penpose_onoff,BR2_PACKAGE_PENPOSE_WINDOW) \
	-DPENPOSE_GL=$(call penpose_onoff,BR2_PACKAGE_PENPOSE_GL)

PENPOSE_DEPENDENCIES += \
	$(if $(BR2_PACKAGE_PENPOSE_DEVICES),libevdev) \
	$(if $(BR2_PACKAGE_PENPOSE_LIBUSB),hidapi libusb) \
	$(if $(BR2_PACKAGE_PENPOSE_WINDOW),fontconfig libdrm sdl2) \
	$(if $(BR2_PACKAGE_PENPOSE_GL),libepoxy)

define PENPOSE_INSTALL_INIT_SYSTEMD
	$(INSTALL) -D -m 0644 $(TARGET_DIR)/usr/share/penpose/boards/penpose.service \
		$(TARGET_DIR)/usr/lib/systemd/system/penpose.service
endef

define PENPOSE_USERS
	penpose -1 penpose -1 * /home/penpose - video,render,input penpose
endef

$(eval $(cmake-package))
