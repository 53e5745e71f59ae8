# The job of tablets_test.py: every scenario leaves its results in /out, the host looks at them afterwards.
. /functions.sh
pump_probe watch /tmp/stop_watch >/out/watch.log 2>&1 &
until_true 20 grep -q watching /out/watch.log
penpose devices >/out/none.txt

# --- A tablet that the machine itself has: QEMU's PenPartner, plugged in, moved and pulled out from outside.
stage penpartner
echo "MARK plug"
until_true 40 listed_are 1
penpose devices --json >/out/penpartner.json
usb=$(sed -n 's/.*"usb": "\(.*\)",*/\1/p' /out/penpartner.json)
driver_of "$usb" >/out/driver_before
hid_driver_of "$usb" >/out/hid_driver_before

# Taken from the kernel and given back: in good order ...
record_until_ready orderly --seconds 1
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
until_true 20 listed_are 1
echo "MARK pull"
until_true 20 listed_are 0
echo "MARK again"
until_true 20 listed_are 1

record_until_ready penpartner
follow /out/penpartner.hid >/dev/vport0p2 &
following=$!
echo "MARK draw"
end_record penpartner
kill $following
until_true 20 listed_are 0

# --- A Windows Ink pen through uhid, read beside the kernel's driver.
stage ink
if [ -f /traces/ink.hid ]; then
  virtual_tablet uhid /traces/ink.hid --go /tmp/go_ink >/out/ink.sent 2>&1 &
  until_true 20 tablets_are 1
  penpose devices --json >/out/ink.json
  record_until_ready ink
  touch /tmp/go_ink
  end_record ink
  until_true 20 tablets_are 0
fi

# --- Wacom tablets as USB devices, each with the kernel's own driver beside us.
stage wacom
for trace in /traces/wacom_*.hid; do
  [ -f "$trace" ] || continue
  name=$(basename "$trace" .hid)
  virtual_tablet usb "$trace" --go "/tmp/go_$name" --keep "/tmp/keep_$name" --pace-us 700 >"/out/$name.sent" 2>&1 &
  until_true 30 tablets_are 1 || { penpose devices; dmesg | tail -5; }
  penpose devices --json >"/out/$name.json"
  # Of several interfaces all are wanted, the touch one too: by path.
  record_until_ready "$name"
  touch "/tmp/go_$name"
  until_true 120 grep -q sent "/out/$name.sent"
  kill -INT "$recorder"
  end_record "$name"
  touch "/tmp/keep_$name"
  until_true 20 tablets_are 0
done

# --- Two tablets at once, one unplugged while its pen draws; the other goes on, and a third one joins.
stage two
virtual_tablet uhid /traces/two_ink.hid --go /tmp/go_two --unplug-after 60 --pace-us 2000 >/out/two_a.sent 2>&1 &
virtual_tablet usb /traces/two_wacom.hid --go /tmp/go_two --keep /tmp/keep_two --pace-us 2000 >/out/two_b.sent 2>&1 &
until_true 30 tablets_are 2
penpose devices --json >/out/two.json
record_until_ready two
touch /tmp/go_two
until_true 60 grep -q sent /out/two_b.sent
until_true 20 grep -q unplugged /out/two.err
virtual_tablet uhid /traces/late.hid --go /tmp/go_late >/out/late.sent 2>&1 &
until_true 20 grep -q "recording Late pen" /out/two.err
touch /tmp/go_late
until_true 20 grep -q "Late pen was unplugged" /out/two.err
kill -INT "$recorder"
end_record two
touch /tmp/keep_two
until_true 20 tablets_are 0

# --- A device that sends garbage under a pen's descriptor, and one whose descriptor is garbage.
stage garbage
virtual_tablet uhid /traces/garbage.hid --go /tmp/go_garbage >/out/garbage.sent 2>&1 &
until_true 20 tablets_are 1
record_until_ready garbage
touch /tmp/go_garbage
end_record garbage
until_true 20 tablets_are 0
penpose decode /out/garbage.hid --csv >/out/garbage.csv 2>/out/garbage.decode_err
echo $? >/out/garbage.decode_status
virtual_tablet uhid /traces/garbage_descriptor.hid --keep /tmp/keep_garbage >/out/garbage_descriptor.sent 2>&1 &
sleep 1
penpose devices --json >/out/garbage_descriptor.json
echo $? >/out/garbage_descriptor.status
touch /tmp/keep_garbage

# --- A tablet that a string tells apart and another string wakes up.
stage strings
virtual_tablet usb /traces/huion.hid --string 201=HUION_T173_200101 --string 200=waking --asleep-until 200 \
  --go /tmp/go_huion --keep /tmp/keep_huion >/out/huion.sent 2>&1 &
until_true 30 tablets_are 1
penpose devices --json >/out/huion.json
record_until_ready huion
usb=$(sed -n 's/.*"usb": "\(.*\)",*/\1/p' /out/huion.json)
driver_of "$usb" >/out/huion_driver_while
touch /tmp/go_huion
until_true 60 grep -q sent /out/huion.sent
kill -INT "$recorder"
end_record huion
driver_of "$usb" >/out/huion_driver_after
touch /tmp/keep_huion
until_true 20 tablets_are 0

# --- The machine sleeps while a tablet is recorded: it is woken before its first report and again afterwards.
stage sleep
virtual_tablet uhid /traces/parblo.hid --go /tmp/go_parblo >/out/parblo.sent 2>&1 &
until_true 20 tablets_are 1
record_until_ready parblo
until_true 20 grep -q "wake feature" /out/parblo.hid
echo "MARK sleep"
echo mem >/sys/power/state
echo "MARK awake"
until_true 20 grep -q "slept" /out/parblo.hid
touch /tmp/go_parblo
end_record parblo

# --- How long a report takes to its stroke, and that none is lost.
stage burst
pump_probe burst "$(cat /burst_seconds)" 1000 >/out/burst.json 2>/out/burst.err
touch /tmp/stop_watch
sleep 0.5
stage end
dmesg >/out/dmesg.txt
