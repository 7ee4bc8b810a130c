#!/usr/bin/env bash
# usage: test.sh MAP DIRECTORY THREADS_PROGRAM [MPI_PROGRAM MPIEXEC]
# The result is the same by one thread, by two, by 1, 2 and 4 ranks, and by a run that was killed and went on.
set -eu
map=$1 threads=$3 mpi=${4-} mpiexec=${5-}
rm -rf "$2" && mkdir -p "$2" && cd "$2"
small="headings 5 width 41 height 37"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

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

# Killed as soon as something is there, with the ranks that it began.
killed() {
  "$@" >/dev/null 2>&1 &
  local pid=$! waited=0
  until [ -s long.part ] && tail -c 20480 long.part | grep -qaP '\x01'; do
    sleep 0.01
    waited=$((waited + 1))
    [ $waited -lt 6000 ] || { echo "nothing was written"; exit 1; }
  done
  kill -KILL $pid $(cat /proc/$pid/task/$pid/children)
  wait $pid 2>/dev/null || true
  [ -e long.part ] && [ ! -e long ] || { echo "it was done before it was killed"; exit 1; }
}
long="headings 256 width 32 height 1280"  # 20480 chunks
"$threads" "$map" whole_run $long >/dev/null
killed "$threads" "$map" long $long threads 1
"$threads" "$map" long $long >said_on
grep -q "^goes on: [1-9][0-9]* of 20480 chunks are there" said_on
cmp whole_run long
if [ -n "$mpi" ]; then
  rm long
  killed "$mpiexec" -n 2 "$mpi" "$map" long $long
  "$mpiexec" -n 2 "$mpi" "$map" long $long >said_on
  grep -q "^goes on: [1-9][0-9]* of 20480 chunks are there" said_on
  cmp whole_run long
fi
# What is left of one job is no beginning of another.
cp whole_run other.part && truncate -s $(($(stat -c %s one) + 15)) other.part
if "$threads" "$map" other $small 2>error; then exit 1; fi
grep -q "other.part: is of another job" error
if "$threads" "$map" other width 0 2>error; then exit 1; fi
grep -qx "error: width: it must be a number from 1 to 65536" error
echo "all the same"
