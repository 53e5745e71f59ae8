# What the jobs of the virtual machine have in common.

# stage NAME: says on the console when a part of the job begins.
stage() {
  read -r up _ </proc/uptime
  echo "STAGE $1 $up"
}

# load MODULE: a driver of the kernel with all that it needs; the host has put down which files those are.
load() {
  for file in $(cat "/modules/$1"); do
    name=${file##*/}
    name=${name%.ko}
    [ -d "/sys/module/${name//-/_}" ] || insmod "$file" || echo "no module $file"
  done
}

# until_true SECONDS COMMAND...: waits for a command to succeed.
until_true() {
  tries=$(($1 * 50))
  shift
  while ! "$@" >/dev/null 2>&1; do
    tries=$((tries - 1))
    [ $tries -gt 0 ] || { echo "GAVE UP waiting: $*"; return 1; }
    sleep 0.02
  done
}

# record_until_ready NAME ARGUMENT...: starts `penpose record` behind us, into /out/NAME.hid unless it is told where,
# and waits until it reads. Its process is in $recorder.
record_until_ready() {
  name=$1
  shift
  case "$*" in *-o*) ;; *) set -- -o "/out/$name.hid" "$@" ;; esac
  penpose record "$@" >"/out/$name.out" 2>"/out/$name.err" &
  recorder=$!
  until_true 30 grep -q recording "/out/$name.err" || cat "/out/$name.err"
}

# end_record NAME: waits for the end of the recorder and keeps its exit status.
end_record() {
  wait "$recorder"
  echo $? >"/out/$1.status"
}

# tablets_are NUMBER: so many have come and not gone, as the watcher that runs all the time has it.
tablets_are() { [ $(($(grep -c ^arrived /out/watch.log) - $(grep -c ^left /out/watch.log))) -eq "$1" ]; }

# all_have NUMBER PATTERN FILE...: so many lines of the files hold it.
all_have() {
  number=$1
  pattern=$2
  shift 2
  [ "$(cat "$@" | grep -c "$pattern")" -eq "$number" ]
}

# event_node NAME: the node of the input device whose name begins so.
event_node() {
  for d in /sys/class/input/event*; do
    case "$(cat "$d/device/name")" in "$1"*) echo "/dev/input/${d##*/}" ;; esac
  done
}
has_event_node() { [ -n "$(event_node "$1")" ]; }

# is_hid ID: the kernel has such a device.
is_hid() { ls /sys/bus/hid/devices | grep -q "$1"; }

# The driver of a USB interface, by its sysfs name.
driver_of() { basename "$(readlink "/sys/bus/usb/devices/$1/driver")" 2>/dev/null; }
has_driver() { [ "$(driver_of "$1")" = "$2" ]; }
hid_driver_of() { for d in /sys/bus/usb/devices/"$1"/0*; do basename "$(readlink "$d/driver")"; done 2>/dev/null; }
