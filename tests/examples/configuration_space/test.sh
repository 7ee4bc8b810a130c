#!/usr/bin/env bash
# usage: test.sh MAP DIRECTORY THREADS_PROGRAM [MPI_PROGRAM MPIEXEC]
# The result is the same by one thread, by two, by 1, 2 and 4 ranks, and by a run that was killed and went on. Nothing
# of another job is gone on from, or written over.
set -eu
folder=$(dirname "$1") threads=$3 mpi=${4-} mpiexec=${5-}
rm -rf "$2" && mkdir -p "$2" && cp "$folder"/yard.{pgm,yaml} "$2" && cd "$2"
map=yard.yaml
small="headings 5 width 41 height 37"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

# refused MESSAGE COMMAND...: it fails, and says so.
refused() {
  local message=$1
  shift
  if "$@" >/dev/null 2>error; then echo "wasn't refused: $*"; exit 1; fi
  grep -q "^error: .*$message" error || { echo "instead of '$message':"; cat error; exit 1; }
}

"$threads" --help | grep -q "^usage: configuration_space map.yaml result"
"$threads" "$map" one $small threads 1 >said
grep -qx "1[0-9]* of 7585 configurations are free" said || { cat said; exit 1; }
"$threads" "$map" two $small threads 2 >/dev/null
cmp one two && cmp one.pgm two.pgm
"$threads" "$map" whole $small whole >said_whole
[ "$(cut -d' ' -f1 said_whole)" -lt "$(cut -d' ' -f1 said)" ]  # safe for whole cells is less
if [ -n "$mpi" ]; then
  for ranks in 1 2 4; do
    "$mpiexec" -n $ranks "$mpi" "$map" ranks_$ranks $small >/dev/null
    cmp one ranks_$ranks
  done
fi

# Killed as soon as something is there. The ranks that it began end with it: the part is nobody's soon.
killed() {
  "$@" >/dev/null 2>&1 &
  local pid=$! waited=0
  until [ -s long.part ] && tail -c 20480 long.part | grep -qaP '\x01'; do
    sleep 0.01
    waited=$((waited + 1))
    [ $waited -lt 6000 ] || { echo "nothing was written"; exit 1; }
  done
  kill -KILL $pid
  wait $pid 2>/dev/null || true
  waited=0
  until flock -n long.part true; do
    sleep 0.01
    waited=$((waited + 1))
    [ $waited -lt 6000 ] || { echo "ranks outlive $1"; exit 1; }
  done
  [ -e long.part ] && [ ! -e long ] || { echo "it was done before it was killed"; exit 1; }
}
long="headings 256 width 32 height 1280"  # 20480 chunks
goes_on() {
  "$@" >said_on 2>/dev/null
  grep -q "^goes on: [1-9][0-9]* of 20480 chunks are there" said_on
  cmp whole_run long
}
"$threads" "$map" whole_run $long >/dev/null
killed "$threads" "$map" long $long threads 1

# What is left of one job is no beginning of another, of any size, and stays what it is.
cp long.part kept
sed -i 's/^resolution.*/resolution: 0.2/' yard.yaml
refused "long.part: is of another job; remove it to begin anew" "$threads" "$map" long $long
cp "$folder/yard.yaml" . && cp yard.pgm image
python3 -c "data = bytearray(open('image', 'rb').read()); data[-1] ^= 0xFE; open('yard.pgm', 'wb').write(data)"
refused "long.part: is of another job" "$threads" "$map" long $long
mv image yard.pgm
for other in "headings 8 width 32 height 1280" "headings 256 width 40 height 1280" "$long whole" "$small"; do
  refused "long.part: is of another job" "$threads" "$map" long $other
done
cmp kept long.part
goes_on "$threads" "$map" long $long
# A result is no other job's, either; its own isn't computed again.
refused "long: is no result of this job; remove it, or name another one" "$threads" "$map" long $small
"$threads" "$map" long $long >said_on
grep -q "^goes on: 20480 of 20480 chunks" said_on
rm long

# Two at once: the second is refused, and the first one isn't disturbed.
"$threads" "$map" long $long >/dev/null threads 1 &
until [ -e long.part ]; do sleep 0.01; done
refused "long.part: another run writes it" "$threads" "$map" long $long
wait
cmp whole_run long
rm long
if [ -n "$mpi" ]; then
  killed "$mpiexec" -n 2 "$mpi" "$map" long $long
  goes_on "$mpiexec" -n 2 "$mpi" "$map" long $long
  rm long
fi

# Killed before it said what it is, and after the last chunk.
size=$(($(stat -c %s one) + 15))
for bytes in 0 $size; do
  truncate -s $bytes begun.part
  "$threads" "$map" begun $small >/dev/null
  cmp one begun
  rm begun
done
cp whole_run long.part
goes_on "$threads" "$map" long $long

# No place for it.
refused "can't write nowhere/result.part: No such file or directory" "$threads" "$map" nowhere/result $small
(
  trap '' XFSZ
  ulimit -f 64
  refused "can't make room for [0-9]* bytes in full.part: File too large" "$threads" "$map" full $long
  [ ! -e full.part ]
)
refused "width: it must be a number from 1 to 65536" "$threads" "$map" other width 0
refused "'depth' is none of headings, width" "$threads" "$map" other depth 1

# Where there is no terminal, as under mpirun, a line now and then.
says_how_far() {
  rm -f slow slow.part
  "$@" "$map" slow headings 256 width 4096 height 1280 progress 1 >/dev/null 2>slow_said &
  local pid=$! waited=0
  until [ -s slow_said ] || [ $waited -ge 600 ]; do
    sleep 0.1
    waited=$((waited + 1))
  done
  kill $pid
  wait $pid 2>/dev/null || true
  grep -qE "^[0-9]+ of 20480 chunks, [0-9]+ a second, [0-9]+ s to go$" slow_said ||
    { echo "no progress"; cat slow_said; exit 1; }
}
says_how_far "$threads"
[ -z "$mpi" ] || says_how_far "$mpiexec" -n 2 "$mpi"
rm -f slow.part
echo "all the same"
