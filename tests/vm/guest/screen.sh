# The job of screen_test.py: the window on a screen without a desktop, until it has drawn the head, then ended politely.
. /functions.sh
export HOME=/tmp XDG_CONFIG_HOME=/tmp/config
export LIBGL_DRIVERS_PATH=/usr/lib/x86_64-linux-gnu/dri
mkdir -p $XDG_CONFIG_HOME/penpose
printf 'steps_seen=1\npose_first=1\n' >$XDG_CONFIG_HOME/penpose/settings
way=$(cat /way)
options=
case $way in
  gl | es) export $(cat /overrides) >/dev/null ;;
  frame_buffer) rm -r /dev/dri; options="--rotate 180" ;;
esac
penpose --fullscreen $options --session /out/drawn.session >/out/app.txt 2>&1 &
app=$!
echo "MARK started"
mouse=/sys/bus/usb/devices/1-1
until_true 300 test -e $mouse
# The host pulls the mouse when it has seen enough.
tries=1200
while [ -e $mouse ]; do
  tries=$((tries - 1))
  [ $tries -gt 0 ] || { echo "GAVE UP waiting for the host"; break; }
  sleep 0.2
done
grep VmHWM /proc/$app/status >/out/memory
kill -TERM $app
wait $app
echo $? >/out/status
echo "MARK ended"
# And the keyboard when it has seen the console.
tries=300
while [ -e /sys/bus/usb/devices/1-2 ] && [ $tries -gt 0 ]; do
  tries=$((tries - 1))
  sleep 0.2
done
