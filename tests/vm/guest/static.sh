# The job of static_test.py: the static program in a root that cannot be written to, without /dev/shm, udevd or a locale.
. /functions.sh
mount -t tmpfs tmp /tmp
mount -t tmpfs out /out
mount -t tmpfs run /run
mv /bin/penpose-static /bin/penpose
mount -o remount,ro / || echo "GAVE UP making the root read-only"
touch /written 2>/dev/null && echo "GAVE UP: the root can be written to"
penpose devices >/out/none.txt 2>&1

# As many as the listing shows, since no other program watches here.
listed() { [ "$(penpose devices --json | grep -c '"node": "/dev/hidraw')" -eq "$1" ]; }
for trace in ink wacom_intuos4 uclogic hand; do
  stage "$trace"
  case $trace in
    ink) kind=uhid options= count=1 ;;
    uclogic) kind=usb options="--string 201=HUION_T173_200101 --bytes 200=70c600067c00ff1fd81300000000000000" count=1 ;;
    hand) kind=usb options= count=2 ;;
    *) kind=usb options= count=1 ;;
  esac
  # shellcheck disable=SC2086
  virtual_tablet $kind "/traces/$trace.hid" $options --pace-us 2000 --go "/tmp/go_$trace" >"/out/$trace.sent" 2>&1 &
  until_true 30 listed "$count"
  penpose devices --json >"/out/$trace.json"
  record_until_ready "$trace"
  until_true 20 all_have "$count" ^recording "/out/$trace.err"
  touch "/tmp/go_$trace"
  end_record "$trace"
  until_true 30 listed 0
done
stage end
dmesg >/out/dmesg.txt
