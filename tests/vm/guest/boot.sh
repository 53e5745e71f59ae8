# The job of boot_test.py: BusyBox's init starts the window from the line that ships; a pen draws in it.
mkdir -p /usr/bin /etc /board /root/.config/penpose
mount -t ext4 -o ro /dev/vda /board
export LD_LIBRARY_PATH=/board/lib
ln -s /board/bin/penpose /usr/bin/penpose
ln -s /board/bin/virtual_tablet /bin/virtual_tablet
ln -s /bin/busybox /usr/bin/env
echo steps_seen=1 >/root/.config/penpose/settings
{ cat /inittab.line; echo "::once:/bin/sh /drawing.sh"; } >/etc/inittab
exec busybox init
