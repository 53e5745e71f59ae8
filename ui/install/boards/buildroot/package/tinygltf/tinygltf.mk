TINYGLTF_VERSION = 2.8.3
TINYGLTF_SITE = $(call github,syoyo,tinygltf,v$(TINYGLTF_VERSION))
TINYGLTF_LICENSE = MIT
TINYGLTF_LICENSE_FILES = LICENSE
TINYGLTF_INSTALL_STAGING = YES
TINYGLTF_INSTALL_TARGET = NO

# Headers alone: it is compiled into penpose.
define TINYGLTF_INSTALL_STAGING_CMDS
	$(INSTALL) -D -m 0644 $(@D)/tiny_gltf.h $(STAGING_DIR)/usr/include/tiny_gltf.h
	$(INSTALL) -D -m 0644 $(@D)/json.hpp $(STAGING_DIR)/usr/include/json.hpp
	$(INSTALL) -D -m 0644 $(@D)/stb_image.h $(STAGING_DIR)/usr/include/stb_image.h
	$(INSTALL) -D -m 0644 $(@D)/stb_image_write.h $(STAGING_DIR)/usr/include/stb_image_write.h
endef

$(eval $(generic-package))
