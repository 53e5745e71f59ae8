# Within boot.sh's machine: a pen is plugged in when the window is there, and all that it drew is kept.
exec >/dev/console 2>&1
. /functions.sh
sessions=/root/.local/state/penpose/sessions
until_true 600 grep -rq "penpose view" $sessions
echo "MARK window"
# The host makes it draw when it has seen the head.
until_true 600 test ! -e /sys/bus/usb/devices/1-1
virtual_tablet uhid /traces/drawn.hid --pace-us 3000 --keep /tmp/keep >/out/sent &
session=$(ls $sessions/*.session)
until_true 300 all_have "$(grep -c ^E: /traces/drawn.hid)" ^E: "$session"
sleep 2
app=$(pidof penpose)
grep -E "VmHWM|VmRSS" "/proc/$app/status" >/out/memory
grep -E "MemTotal|MemAvailable" /proc/meminfo >>/out/memory
echo "MARK drawn"
until_true 600 test ! -e /sys/bus/usb/devices/1-2
kill -TERM "$app"
until_true 20 test ! -e "/proc/$app"
cp "$session" /out/drawn.session
tar -C /out -cf - . >/dev/vport0p1
echo "MARK end"
sync
poweroff -f
