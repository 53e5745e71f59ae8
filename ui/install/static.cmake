# PENPOSE_STATIC: all libraries as archives, and one program that asks the system for nothing but the kernel.
set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
# What the archives need themselves.
set(PKG_CONFIG_ARGN --static)
target_link_options(penpose_options INTERFACE -static-pie)
