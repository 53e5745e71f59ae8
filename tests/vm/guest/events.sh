# The job of events_test.py: pens through the kernel's event devices.
. /functions.sh
count=$(cat /count)
gone() { ! has_event_node "$1"; }
penpose devices >/out/none.txt
pump_probe listing >/out/listing.none

# --- One pen of which the kernel makes both nodes, read both ways at once.
stage both
virtual_tablet uhid /traces/ink.hid --go /tmp/go_both --keep /tmp/keep_both >/out/both.sent 2>&1 &
until_true 30 has_event_node "Ink pen"
until_true 30 test -e /dev/hidraw0
penpose devices --json >/out/both.json
penpose devices >/out/both.txt
record_until_ready both_event --device "$(event_node "Ink pen")"
event_recorder=$recorder
record_until_ready both_hidraw --device /dev/hidraw0
touch /tmp/go_both
until_true 600 grep -q ^sent /out/both.sent
sleep 1
touch /tmp/keep_both
wait "$event_recorder"
echo $? >/out/both_event.status
end_record both_hidraw
until_true 20 gone "Ink pen"

# --- A pen that has an event device alone, with a pad and fingers beside it; it is unplugged while it draws.
stage alone
pump_probe watch /tmp/stop_watch >/out/watch.log 2>&1 &
until_true 20 grep -q watching /out/watch.log
for part in pen pad fingers; do
  virtual_input /traces/$part.evemu --go /tmp/go_$part --keep /tmp/keep_$part --place board/input0 --unplug-after "$count" >/out/$part.sent 2>&1 &
done
until_true 30 has_event_node "Board Pen"
until_true 30 has_event_node "Board Pad"
until_true 30 has_event_node "Board Finger"
penpose devices --json >/out/alone.json
penpose devices >/out/alone.txt
for n in 1 2 3 4 5 6 7; do
  virtual_input /traces/keyboard.evemu --keep /tmp/keep_keyboards --place board/input$n >>/out/keyboards.sent 2>&1 &
done
until_true 30 all_have 7 ^sent /out/keyboards.sent
pump_probe listing >/out/listing.ten
touch /tmp/keep_keyboards
until_true 20 gone "Keyboard"
record_until_ready alone
until_true 30 all_have 3 ^recording /out/alone.err
touch /tmp/go_pad /tmp/go_fingers
until_true 30 all_have 2 ^sent /out/pad.sent /out/fingers.sent
touch /tmp/keep_pad
touch /tmp/go_pen
until_true 600 grep -q ^sent /out/pen.sent
touch /tmp/keep_fingers
touch /tmp/keep_pen
end_record alone
until_true 20 grep -q "^left .*Board Pen" /out/watch.log
touch /tmp/stop_watch

# --- What the kernel's queue cannot hold while the program stands still is told, and the state after it is right.
stage stalled
virtual_input /traces/short.evemu --go /tmp/go_stalled --keep /tmp/keep_stalled >/out/stalled.sent 2>&1 &
until_true 30 has_event_node "Short Pen"
record_until_ready stalled
kill -STOP "$recorder"
touch /tmp/go_stalled
until_true 30 grep -q ^sent /out/stalled.sent
kill -CONT "$recorder"
sleep 1
touch /tmp/keep_stalled
end_record stalled
until_true 20 gone "Short Pen"

# --- A pen that is recorded is kept from the desktop, which is `cat` here: from a moment on in which it is away, and by one
# recorder at a time.
stage exclusive
virtual_input /traces/shared.evemu --pace-us 5000 --go /tmp/go_shared --pause-after 25 --pause-after 200 --pause-after 400 --keep /tmp/keep_shared >/out/shared.sent 2>&1 &
until_true 30 has_event_node "Shared Pen"
cat "$(event_node "Shared Pen")" >/out/desktop.raw &
sleep 0.2
touch /tmp/go_shared
until_true 30 grep -q "paused after 25" /out/shared.sent
record_until_ready first
first=$recorder
sleep 0.3
touch /tmp/go_shared.25
until_true 30 grep -q "paused after 200" /out/shared.sent
stat -c %s /out/desktop.raw >/out/desktop.before
record_until_ready second
second=$recorder
until_true 30 grep -q "another program" /out/second.err
kill -TERM "$first"
wait "$first"
until_true 30 grep -q "let go" /out/second.hid
touch /tmp/go_shared.200
until_true 30 grep -q "paused after 400" /out/shared.sent
stat -c %s /out/desktop.raw >/out/desktop.while
kill -TERM "$second"
wait "$second"
touch /tmp/go_shared.400
until_true 30 grep -q ^sent /out/shared.sent
touch /tmp/keep_shared
until_true 20 gone "Shared Pen"

# --- Somebody in the group `input`, who may not open hidraw; somebody who may open neither; a program that has it alone.
stage rights
echo 'root:x:0:0:root:/:/bin/sh' >/etc/passwd
echo 'pen:x:1000:1000:pen:/tmp:/bin/sh' >>/etc/passwd
echo 'guest:x:1001:1001:guest:/tmp:/bin/sh' >>/etc/passwd
printf 'root:x:0:\ninput:x:104:pen\npen:x:1000:\nguest:x:1001:\n' >/etc/group
chmod 777 /out /tmp
virtual_tablet uhid /traces/small.hid --pace-us 8000 --go /tmp/go_small --keep /tmp/keep_small >/out/small.sent 2>&1 &
until_true 30 has_event_node "Small pen"
until_true 30 test -e /dev/hidraw0
chmod 600 /dev/hidraw0
node=$(event_node "Small pen")
chgrp input "$node"
chmod 660 "$node"
su -s /bin/sh guest -c "penpose devices" >/out/guest.txt 2>&1
su -s /bin/sh pen -c "penpose devices --json" >/out/member.json 2>/out/member.err
su -s /bin/sh pen -c "penpose record -o /out/member.hid" >/out/member.out 2>/out/member.log &
recorder=$!
until_true 30 grep -q recording /out/member.log
touch /tmp/go_small
until_true 60 grep -q ^sent /out/small.sent
touch /tmp/keep_small
end_record member
until_true 20 gone "Small pen"

# --- What was recorded, drawn here.
stage replay
penpose replay /out/member.hid --model builtin:head --session /out/here.session --json >/out/here.json 2>/out/here.err
stage end
