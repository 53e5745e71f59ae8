include $(sort $(wildcard $(BR2_EXTERNAL_PENPOSE_PATH)/package/*/*.mk))
