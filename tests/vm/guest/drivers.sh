# The job of drivers_test.py: every trace is given to the kernel's own driver, what its nodes said is kept.
. /functions.sh
while read -r name kind port; do
  stage "$name"
  driver_probe "$kind" "/traces/$name.hid" "$port" >"/out/$name.rows" 2>"/out/$name.err" || echo "no rows of $name: $(cat "/out/$name.err")"
done </traces/list
