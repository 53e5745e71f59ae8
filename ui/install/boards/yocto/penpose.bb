SUMMARY = "Poses and rigs 3D characters by drawing, with a pen tablet"
LICENSE = "MIT"
LIC_FILES_CHKSUM = "file://LICENSE;md5=0b0b962e80869657eef2f26e3c0b060d"

# Where the source tree is: EXTERNALSRC:pn-penpose = "/path/to/penpose" in local.conf.
inherit externalsrc cmake pkgconfig useradd ${@bb.utils.filter('DISTRO_FEATURES', 'systemd', d)}

DEPENDS = "cli11 draco glm jpeg libpng libwebp meshoptimizer pugixml tinygltf xxhash zlib"

PACKAGECONFIG ??= "devices"
PACKAGECONFIG[devices] = "-DPENPOSE_DEVICES=ON,-DPENPOSE_DEVICES=OFF,libevdev"
PACKAGECONFIG[libusb] = "-DPENPOSE_LIBUSB=ON,-DPENPOSE_LIBUSB=OFF,hidapi libusb1"
PACKAGECONFIG[window] = "-DPENPOSE_WINDOW=ON,-DPENPOSE_WINDOW=OFF,fontconfig imgui libdrm libsdl2"
PACKAGECONFIG[gl] = "-DPENPOSE_GL=ON,-DPENPOSE_GL=OFF,libepoxy libsdl2"

# Man pages and completions are written by a program of the board, which the building machine cannot run.
EXTRA_OECMAKE = "-DPENPOSE_TESTS=OFF -DPENPOSE_WERROR=OFF -DPENPOSE_OPENMESH=OFF -DPENPOSE_PAGES=OFF -DPENPOSE_SOUND=OFF -DPENPOSE_SPEECH=OFF -DPENPOSE_PORTAL=OFF -DPENPOSE_ADDON=OFF"

USERADD_PACKAGES = "${PN}"
USERADD_PARAM:${PN} = "--system --create-home --groups video,render,input penpose"

do_install:append() {
    if ${@bb.utils.contains('PACKAGECONFIG', 'window', 'true', 'false', d)}; then
        install -D -m 0644 ${D}${datadir}/penpose/boards/penpose.service ${D}${systemd_system_unitdir}/penpose.service
    fi
}
SYSTEMD_SERVICE:${PN} = "${@bb.utils.contains('PACKAGECONFIG', 'window', 'penpose.service', '', d)}"

FILES:${PN} += "${datadir} ${nonarch_base_libdir}/udev ${nonarch_libdir}/udev"
