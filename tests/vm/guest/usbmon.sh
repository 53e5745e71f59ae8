# The job of usbmon_test.py: tablets one after another, each plugged in, drawn with and pulled out while usbmon captures all buses
# and `penpose record` reads hidraw or libusb beside it.
. /functions.sh
pump_probe watch /tmp/stop_watch >/out/watch.log 2>&1 &
until_true 20 grep -q watching /out/watch.log

# capture NAME: starts a capture of all buses into /out/NAME.pcap; it ends with end_captures.
captures=
capture() {
  usb_capture /dev/usbmon0 "/out/$1.pcap" /tmp/stop_capture >"/out/$1.packets" 2>"/out/$1.capture_err" &
  captures="$captures $!"
  until_true 20 grep -q capturing "/out/$1.capture_err"
}
end_captures() {
  touch /tmp/stop_capture
  for pid in $captures; do wait "$pid"; done
  captures=
  rm /tmp/stop_capture
}

# draw NAME INTERFACES PORT OPTION...: the whole life of a tablet.
draw() {
  name=$1
  interfaces=$2
  port=$3
  shift 3
  stage "$name"
  capture "$name"
  virtual_tablet usb "/traces/$name.hid" --go "/tmp/go_$name" --port "$port" --pace-us 2000 "$@" >"/out/$name.sent" 2>&1 &
  until_true 30 tablets_are "$interfaces"
  record_until_ready "$name"
  until_true 30 all_have "$interfaces" ^recording "/out/$name.err"
  [ "$name" != intuos4 ] || capture late
  touch "/tmp/go_$name"
  end_record "$name"
  until_true 20 tablets_are 0
  end_captures
}
draw intuos4 1 0
draw ink 1 1
draw hand 2 2
draw huion 1 3 --string 201=HUION_T173_200101 --string 200=waking --asleep-until 200
touch /tmp/stop_watch
stage end
dmesg >/out/dmesg.txt
