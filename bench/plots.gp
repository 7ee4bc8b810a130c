# Draws times.svg and figure12.svg from times.dat and grid.dat in the directory `report`.
# Columns of times.dat: vertices, then the times; of grid.dat: vertices fixed, moving, then the times, in this order:
methods = "cold cached paper 'via FCL' 'GJK ccd' 'GJK indep' BVH floor"
column(k, first) = first + k
set encoding utf8

# times.svg: polygons of equally many vertices, one panel a kind and trajectory.
set terminal svg size 1500,800 font "sans-serif,13" background "white"
set output report."/times.svg"
array color[8] = ["#9ec5f7", "#1d4ed8", "#f59e0b", "#0f9d58", "#dc2626", "#a855f7", "#6b7280", "#c7c7c7"]
set logscale xy
set format y "10^{%L}"
set xrange [6:1400]
set yrange [4:1e6]
set xtics (8, 16, 32, 64, 128, 256, 512, 1024) font ",11"
set grid ytics lc rgb "#e5e7eb"
set border lc rgb "#6b7280"
unset key
kinds = "convex slim starred contour irregular 'with hole'"
set multiplot layout 2,7 title "Time per query over the vertices of both polygons: circular (above) and linear trajectory (below)"
do for [trajectory in "circular linear"] {
  set xlabel trajectory eq "linear" ? "vertices of each polygon" : ""
  do for [i = 1:6] {
    kind = word(kinds, i)
    set title kind.", ".trajectory
    set ylabel i == 1 ? "ns per query" : ""
    plot for [k = 1:8] report."/times.dat" index kind." ".trajectory using 1:(column(column(k, 1))) with linespoints \
      pt 7 ps 0.5 lw (k == 2 ? 3 : 1.6) lc rgb color[k] notitle
  }
}
unset multiplot
