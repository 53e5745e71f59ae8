# On the board of boot_test.py, beside the window: a pen is plugged in when the window is there, and all that it drew is kept.
export PATH=/usr/lib/busybox:/usr/bin
exec >/dev/console 2>&1 </dev/null
. /functions.sh
# Looks once in a second, since the only processor is the window's.
until_there() {
  tries=300
  while ! "$@" >/dev/null 2>&1; do
    tries=$((tries - 1))
    [ $tries -gt 0 ] || { echo "GAVE UP waiting: $*"; return 1; }
    sleep 1
  done
}
is_pulled() { [ ! -e "/sys/bus/usb/devices/$1" ]; }
session() { ls /root/.local/state/penpose/sessions/*.session /home/penpose/.local/state/penpose/sessions/*.session 2>/dev/null | tail -n 1; }
session_has() { grep -q "$1" "$(session)"; }
has_both_steps() { [ "$(grep -c '^# penpose state' "$session")" -ge 2 ]; }

until_there session_has "penpose view"
stage window
echo "MARK window"
# The host pulls the mouse when it has seen the head, then the keyboard when it has seen what was drawn.
until_there is_pulled 1-1
session=$(session)
app=$(pidof penpose)
virtual_tablet uhid /traces/drawn.hid --go /tmp/go --pace-us 20000 --keep /tmp/keep >/out/sent 2>&1 &
until_there session_has "N: Board Pen"
# udev may still be at work on its other node.
[ -d /run/udev ] && udevadm settle
sleep 2
stage plugged
touch /tmp/go
# The reports of a pen in the air are written with what comes next, so that counting them says nothing.
until_there has_both_steps
until_there grep -q ^sent /out/sent
stage drawn
grep -E "Name|Uid|VmHWM|VmRSS|VmSwap|RssAnon|RssFile|RssShmem" "/proc/$app/status" >/out/memory
cat /proc/meminfo >/out/meminfo
echo "MARK drawn"
until_there is_pulled 1-2
if [ -d /run/systemd/system ]; then
  loginctl list-sessions --no-legend >/out/sessions
  systemctl stop penpose
  systemctl show penpose >/out/unit
  journalctl -b --no-pager >/out/journal
else
  kill -TERM "$app"
fi
until_there test ! -e "/proc/$app"
cp "$session" /out/drawn.session
tar -C /out -cf - . >/dev/vport0p1
echo "MARK end"
sync
poweroff -f
