# Sourced by ui/run and tests/run: installs Debian packages that are missing, and nothing twice.

# install_packages LIST...: the packages named in the first column of the files LIST.
install_packages() {
  local missing=() package
  while read -r package _; do
    case "$package" in ''|'#'*) continue ;; esac
    # Node.js may have been installed in another way than by Debian; a program that runs is enough.
    case "$package" in
      nodejs) command -v node >/dev/null 2>&1 && continue ;;
      # The virtual machine of the tests is one of this kind alone.
      linux-image-amd64) [ "$(dpkg --print-architecture)" = amd64 ] || continue ;;
      # Debian has it for 64-bit machines alone.
      libopenmesh-dev) [ "$(dpkg --print-architecture)" != armhf ] || continue ;;
      npm) command -v npm >/dev/null 2>&1 && continue ;;
    esac
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done < <(cat "$@")
  [ ${#missing[@]} -eq 0 ] && return 0
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
      printf 'these packages are missing: %s; install them as root with: apt-get install %s\n' "${missing[*]}" "${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  printf 'installing: %s\n' "${missing[*]}"
  "${as_root[@]}" apt-get update -qq || printf 'the package lists could not be renewed; going on with the old ones\n' >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# build_shown WHAT ARGUMENT...: `cmake --build build ARGUMENT...` with a line that says how much of WHAT is built and about how
# long the rest takes: on a terminal one line that is written over, else a line every ten percent. Compilers that ran already
# say how long those that are left will take, since they take alike.
# Needs `set -o pipefail`. The whole of the output is in build/build.log; of a failure its first errors are shown.
build_shown() {
  local log=build/build.log status=0 terminal=0 what=$1
  shift
  [ -t 1 ] && terminal=1
  NINJA_STATUS='[%f/%t %e] ' cmake --build build "${@}" 2>&1 | tee "$log" | awk -v terminal="$terminal" -v what="$what" '
    match($0, /^\[[0-9]+\/[0-9]+ [0-9.]+\]/) {
      split(substr($0, 2, RLENGTH - 2), n, /[\/ ]/)
      percent = n[2] > 0 ? int(100 * n[1] / n[2]) : 100
      if (percent == shown || (!terminal && percent < shown + 10)) next
      shown = percent
      minutes = n[1] > 0 ? n[3] * (n[2] - n[1]) / n[1] / 60 : 0
      left = percent == 100 ? "" : minutes < 1 ? ", less than a minute left" : sprintf(", %d min left", minutes + 0.5)
      line = "building " what ": " percent " %" left
      printf terminal ? "\r%-60s" : "%s\n", line
      fflush()
    }
    END { if (terminal && shown != "") print "" }' || status=$?
  [ "$status" -eq 0 ] && return 0
  grep -A 12 -m 3 -E 'error|FAILED' "$log" >&2 || tail -n 20 "$log" >&2
  printf 'building failed; all of it is in %s\n' "$log" >&2
  return 1
}
