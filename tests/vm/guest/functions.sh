# What the jobs of the virtual machine have in common.

# stage NAME: says on the console when a part of the job begins.
stage() {
  read -r up _ </proc/uptime
  echo "STAGE $1 $up"
}

# until_true SECONDS COMMAND...: waits for a command to succeed.
until_true() {
  tries=$(($1 * 10))
  shift
  while ! "$@" >/dev/null 2>&1; do
    tries=$((tries - 1))
    [ $tries -gt 0 ] || { echo "GAVE UP waiting: $*"; return 1; }
    sleep 0.1
  done
}

# record_until_ready NAME ARGUMENT...: starts `penpose record -o /out/NAME.hid` behind us and waits until it reads.
# Its process is in $recorder.
record_until_ready() {
  name=$1
  shift
  penpose record -o "/out/$name.hid" "$@" >"/out/$name.out" 2>"/out/$name.err" &
  recorder=$!
  until_true 30 grep -q recording "/out/$name.err" || cat "/out/$name.err"
}

# end_record NAME: waits for the end of the recorder and keeps its exit status.
end_record() {
  wait "$recorder"
  echo $? >"/out/$1.status"
}

# listed_are NUMBER: so many does `penpose devices` list; starting it takes its time here.
listed_are() { [ "$(penpose devices --json | grep -c '"path"')" -eq "$1" ]; }

# tablets_are NUMBER: so many have come and not gone, as the watcher that runs all the time has it.
tablets_are() { [ $(($(grep -c ^arrived /out/watch.log) - $(grep -c ^left /out/watch.log))) -eq "$1" ]; }

# The driver of a USB interface, by its sysfs name.
driver_of() { basename "$(readlink "/sys/bus/usb/devices/$1/driver")" 2>/dev/null; }
has_driver() { [ "$(driver_of "$1")" = "$2" ]; }
hid_driver_of() { for d in /sys/bus/usb/devices/"$1"/0*; do basename "$(readlink "$d/driver")"; done 2>/dev/null; }

# follow FILE: prints a file while it grows.
follow() {
  exec <"$1"
  while :; do
    cat
    sleep 0.02
  done
}
