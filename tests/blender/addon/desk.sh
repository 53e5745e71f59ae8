# What scripts with a window share, to be sourced: Blender with the add-on under Xvfb, a mouse, and Python that is told to it.
# Wants `here` (this folder), and open_window BLENDER ZIP MODEL first; ends with `end STATUS`.
work=$(mktemp -d)
mkdir "$work/commands" "$work/home"

open_window() {
    Xvfb -displayfd 3 -screen 0 1380x860x24 3>"$work/display" 2>/dev/null &
    server=$!
    for _ in $(seq 50); do [ -s "$work/display" ] && break; sleep 0.2; done
    DISPLAY=:$(cat "$work/display")
    export DISPLAY HOME="$work/home" LIBGL_ALWAYS_SOFTWARE=1
    unset WAYLAND_DISPLAY
    "$1" --window-geometry 0 0 1380 860 --python "$here/window.py" -- "$2" "$3" "$work/commands" >"$work/log" 2>&1 &
    blender=$!
    for _ in $(seq 600); do
        grep -q '^ready' "$work/log" 2>/dev/null && break
        kill -0 "$blender" 2>/dev/null || { cat "$work/log"; end 1; }
        sleep 0.2
    done
    sleep 3
    xdotool windowfocus "$(xdotool search --onlyvisible --name Blender | head -1)"
}

end() {
    kill "$blender" "$server" 2>/dev/null
    wait 2>/dev/null
    rm -rf "$work"
    exit "$1"
}

tell() { # runs Python in Blender and prints what it does
    rm -f "$work"/commands/c.out
    cat >"$work/commands/c.new"
    mv "$work/commands/c.new" "$work/commands/c.py"
    for _ in $(seq 300); do [ -f "$work/commands/c.out" ] && break; sleep 0.1; done
    cat "$work/commands/c.out"
}

press() { xdotool mousemove "$1" "$2"; sleep 0.4; xdotool mousedown 1; sleep 0.2; }
move() { while [ $# -gt 1 ]; do xdotool mousemove "$1" "$2"; sleep 0.1; shift 2; done; sleep 0.5; }
lift() { xdotool mouseup 1; sleep 1; }
mouth() { press 532 431; move 545 429 558 428 570 427 582 428 594 429 606 431; }
smile() { press 520 415; move 532 420 545 425 558 428 570 429 582 428 594 425 606 420 619 415; }
