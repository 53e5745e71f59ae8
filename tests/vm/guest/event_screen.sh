# The job of screen_test.py: the window on a screen without a desktop, until it has drawn the head and what a pen of an event
# device drew on it, then ended politely.
. /functions.sh
export HOME=/tmp XDG_CONFIG_HOME=/tmp/config
export LIBGL_DRIVERS_PATH=/usr/lib/x86_64-linux-gnu/dri
mkdir -p $XDG_CONFIG_HOME/penpose
printf 'steps_seen=1\npose_first=1\n' >$XDG_CONFIG_HOME/penpose/settings
penpose --fullscreen --session /out/drawn.session >/out/app.txt 2>&1 &
app=$!
devices=/sys/bus/usb/devices
is_pulled() { [ ! -e $devices/"$1" ]; }
until_true 60 test -e $devices/1-2
# The host pulls the mouse, then the keyboard, when it has seen enough.
echo "MARK started"
until_true 400 is_pulled 1-1

# The first stroke is drawn to its end; in the second one the pen is unplugged.
virtual_input /traces/pen.evemu --pace-us 10000 --go /tmp/go --pause-after 60 --unplug-after 80 >/out/pen.sent 2>&1 &
until_true 60 has_event_node "Board Pen"
cat "$(event_node "Board Pen")" >/out/desktop.raw &
until_true 60 grep -q "N: Board Pen" /out/drawn.session
sleep 0.5
touch /tmp/go
until_true 60 grep -q ^paused /out/pen.sent
echo "MARK drawn"
until_true 400 is_pulled 1-2
touch /tmp/go.60
until_true 60 grep -q "penpose gone" /out/drawn.session
kill -TERM $app
wait $app
echo $? >/out/status
