# The job of uclogic_test.py: each tablet of the list is plugged in, woken by the kernel's driver hid-uclogic, and its reports are sent
# while `penpose record` reads hidraw and `driver_probe` the event devices.
. /functions.sh
pump_probe watch /tmp/stop_watch >/out/watch.log 2>&1 &
until_true 20 grep -q watching /out/watch.log
while read -r name options; do
  stage "$name"
  # shellcheck disable=SC2086
  driver_probe usb "/traces/$name.hid" $options --go "/tmp/go_$name" >"/out/$name.rows" 2>"/out/$name.err_rows" &
  probe=$!
  until_true 30 grep -q "^arrived " /out/watch.log
  until_true 30 grep -q "^node " "/out/$name.rows"
  penpose devices --json >"/out/$name.json"
  record_until_ready "$name"
  touch "/tmp/go_$name"
  until_true 120 grep -q "^end " "/out/$name.rows"
  wait "$probe"
  end_record "$name"
  until_true 20 tablets_are 0
done </traces/list
touch /tmp/stop_watch
stage end
dmesg >/out/dmesg.txt
