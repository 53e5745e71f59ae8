# The job of tablets_test.py: every scenario leaves its results in /out, the host looks at them afterwards.
. /functions.sh
pump_probe watch /tmp/stop_watch >/out/watch.log 2>&1 &
until_true 20 grep -q watching /out/watch.log
penpose devices >/out/none.txt

# --- A tablet that the machine itself has: QEMU's PenPartner, plugged in, moved and pulled out from outside.
stage penpartner
echo "MARK plug"
until_true 40 tablets_are 1
penpose devices --json >/out/penpartner.json
usb=$(sed -n 's/.*"usb": "\(.*\)",*/\1/p' /out/penpartner.json)
driver_of "$usb" >/out/driver_before
hid_driver_of "$usb" >/out/hid_driver_before

# Taken from the kernel and given back: in good order ...
record_until_ready orderly --seconds 0.3
driver_of "$usb" >/out/driver_while
end_record orderly
driver_of "$usb" >/out/driver_after
# ... and when the program is killed.
record_until_ready killed
driver_of "$usb" >/out/driver_while_killed
kill -9 "$recorder"
wait "$recorder"
until_true 20 has_driver "$usb" usbhid
driver_of "$usb" >/out/driver_after_kill
penpose devices --json >/out/after_kill.json
echo "MARK pull"
until_true 20 tablets_are 0

# Without the kernel's own driver for it, which would make it a pen; what is recorded goes to the host as it comes.
stage draw
rmmod wacom
echo "MARK again"
until_true 20 tablets_are 1
record_until_ready penpartner -o /dev/vport0p2
echo "MARK draw"
end_record penpartner
until_true 20 tablets_are 0
load wacom

# --- Many at once, recorded by one program: a Windows Ink pen that is unplugged right after its last report and one that
# is while it draws, Wacom tablets with the kernel's own driver beside us, one that a string tells apart and another string
# wakes up, one that the kernel's driver has woken, one that sends garbage, and one whose descriptor is garbage.
stage many
plug() { # plug KIND NAME OPTION...
  kind=$1
  name=$2
  shift 2
  virtual_tablet "$kind" "/traces/$name.hid" --go /tmp/go "$@" >"/out/$name.sent" 2>&1 &
}
wacoms=0
for trace in /traces/wacom_*.hid; do
  plug usb "$(basename "$trace" .hid)" --port $((30 * wacoms)) --keep /tmp/keep --pace-us 2000
  wacoms=$((wacoms + 1))
done
interfaces=$(cat /traces/wacom_*.hid | grep -c ^R:)
plug usb huion --port $((30 * wacoms)) --keep /tmp/keep --string 201=HUION_T173_200101 --string 200=waking --asleep-until 200
# x and y up to 50800 and 31750, pressure up to 8191, 5080 lines an inch
plug usb uclogic --port $((30 * wacoms + 30)) --keep /tmp/keep --string 201=HUION_T173_200101 --bytes 200=70c600067c00ff1fd81300000000000000
plug uhid garbage_descriptor --keep /tmp/keep
until_true 20 is_hid 0003:1B96:0023
plug uhid ink
plug uhid pulled --unplug-after 60 --pace-us 2000
plug uhid garbage --keep /tmp/keep
until_true 30 tablets_are $((interfaces + 5)) || { penpose devices; dmesg | tail -5; }
penpose devices --json >/out/many.json
echo $? >/out/many.devices_status
usb=$(awk -F'"' '/"name"/ { name = $4 } /"usb"/ && name == "Huion asleep" { print $4 }' /out/many.json)
record_until_ready many
until_true 30 all_have $((interfaces + 5)) ^recording /out/many.err
driver_of "$usb" >/out/huion_driver_while
touch /tmp/go
until_true 20 all_have 2 unplugged /out/many.err
# A third ink pen joins while the others go on.
virtual_tablet uhid /traces/late.hid --go /tmp/go_late >/out/late.sent 2>&1 &
until_true 20 grep -q "recording Late pen" /out/many.err
until_true 20 grep -q "^arrived .*Late pen" /out/watch.log
touch /tmp/go_late
until_true 20 grep -q "Late pen was unplugged" /out/many.err
until_true 120 all_have $((wacoms + 7)) ^sent /out/*.sent
# Another one sends more than the kernel keeps while the program does not run.
virtual_tablet uhid /traces/stalled.hid --go /tmp/go_stalled --keep /tmp/keep_stalled >/out/stalled.sent 2>&1 &
until_true 20 grep -q "recording Stalled pen" /out/many.err
until_true 20 grep -q "^arrived .*Stalled pen" /out/watch.log
kill -STOP "$recorder"
touch /tmp/go_stalled
until_true 20 grep -q sent /out/stalled.sent
kill -CONT "$recorder"
touch /tmp/keep_stalled
until_true 20 grep -q "Stalled pen was unplugged" /out/many.err
kill -INT "$recorder"
end_record many
driver_of "$usb" >/out/huion_driver_after
touch /tmp/keep
until_true 20 tablets_are 0

# --- Keys, ring and fingers of a tablet with two interfaces, one key of which is held when it is pulled out.
stage hand
virtual_tablet usb /traces/hand.hid --go /tmp/go_hand --pace-us 2000 >/out/hand.sent 2>&1 &
until_true 20 tablets_are 2
penpose devices --json >/out/hand.json
record_until_ready hand
until_true 20 all_have 2 ^recording /out/hand.err
touch /tmp/go_hand
end_record hand
until_true 20 tablets_are 0
# The fingers' interface through libusb, by its place.
virtual_tablet usb /traces/hand.hid --go /tmp/go_hand_usb --pace-us 2000 --port 1 >/out/hand_usb.sent 2>&1 &
until_true 20 tablets_are 2
penpose devices --json >/out/hand_usb.json
usb=$(sed -n 's/.*"usb": "\(.*:1.1\)",*/\1/p' /out/hand_usb.json)
penpose record -o /out/hand_usb.hid --device "usb:$usb" >/out/hand_usb.out 2>/out/hand_usb.err &
recorder=$!
until_true 30 grep -q recording /out/hand_usb.err
# Somebody has to take what the pen's interface sends.
cat /dev/hidraw* >/dev/null 2>&1 &
touch /tmp/go_hand_usb
end_record hand_usb
until_true 20 tablets_are 0

# --- A tablet behind a wireless receiver, which says which one it is; the kernel's driver makes two nodes anew then.
stage receiver
virtual_tablet usb /traces/receiver.hid --go /tmp/go_receiver --keep /tmp/keep_receiver --pace-us 10000 --port 2 >/out/receiver.sent 2>&1 &
until_true 20 tablets_are 3
penpose devices --json >/out/receiver.json
record_until_ready receiver
until_true 20 all_have 3 ^recording /out/receiver.err
touch /tmp/go_receiver
until_true 60 grep -q ^sent /out/receiver.sent
touch /tmp/keep_receiver
end_record receiver
until_true 20 tablets_are 0

# --- The light of a ring: the kernel's driver switches it where it has the tablet, and where it has not, we do.
stage lights
lights() { # lights NAME PORT PACE_US
  virtual_tablet usb /traces/lights.hid --go "/tmp/go_$1" --keep "/tmp/keep_$1" --pace-us "$3" --port "$2" >"/out/$1.sent" 2>&1 &
  until_true 20 tablets_are 1
  # The driver sets up what it found a second later.
  sleep 2
  pump_probe lights "/tmp/stop_$1" >"/out/$1.log" 2>&1 &
  probe=$!
  until_true 20 grep -q ^light "/out/$1.log"
  touch "/tmp/go_$1"
  until_true 30 grep -q "^light 3" "/out/$1.log"
  sleep 0.5
  touch "/tmp/stop_$1"
  wait "$probe"
  pump_probe lights "/tmp/stop_$1" >"/out/$1.again" 2>&1
  touch "/tmp/keep_$1"
  until_true 20 tablets_are 0
}
# The driver counts presses by the light that it has on, and sets that in its own time.
lights lights_kernel 3 1000000
rmmod wacom
lights lights_bare 4 200000
load wacom

# --- The machine sleeps while a tablet is recorded: it is woken before its first report and again afterwards.
stage sleep
virtual_tablet uhid /traces/parblo.hid --go /tmp/go_parblo >/out/parblo.sent 2>&1 &
until_true 20 tablets_are 1
record_until_ready parblo
until_true 20 grep -q "wake feature" /out/parblo.hid
# The kernel counts a sleep by a clock of whole seconds, and by that alone where its own goes wrong by more than two.
date -s "@$(($(date +%s) - 60))" >/dev/null
echo "MARK sleep"
echo mem >/sys/power/state
echo "MARK awake"
until_true 20 grep -q "slept" /out/parblo.hid
touch /tmp/go_parblo
end_record parblo
until_true 20 tablets_are 0
touch /tmp/stop_watch
stage end
dmesg >/out/dmesg.txt
