# Draws times.svg and figure12.svg from times.dat and grid.dat in the directory `report`.
# Their columns: vertices (in grid.dat fixed, then moving), then the times of these eight methods in this order.
array label[8] = ["tricover, cold", "tricover, cached", "the paper's Algorithm 3, cached", \
  "tricover in fcl::collide, cached", "FCL GJK (libccd) on convex pieces", "FCL GJK (indep) on convex pieces", \
  "FCL BVH of triangles", "fcl::collide on two spheres"]
array color[8] = ["#7dd3fc", "#1d4ed8", "#f59e0b", "#0f9d58", "#dc2626", "#a855f7", "#374151", "#c4c4c4"]
set encoding utf8
set border lc rgb "#6b7280"

# times.svg: polygons of equally many vertices, one panel a kind and trajectory.
set terminal svg size 1500,860 font "sans-serif,13" background "white"
set output report."/times.svg"
set logscale x 2
set logscale y
set xrange [6:1400]
set yrange [4:1e6]
set xtics (8, 32, 128, 512) nomirror
set ytics nomirror
set grid xtics ytics lt 1 lc rgb "#e5e7eb" lw 1
unset key
set multiplot layout 2,6 margins 0.055,0.99,0.17,0.91 spacing 0.012,0.1 \
  title "Time per query over the vertices of each of the two polygons" font ",17"
do for [trajectory in "circular linear"] {
  do for [i = 1:6] {
    kind = word("convex slim starred contour irregular 'with hole'", i)
    set title kind.", ".trajectory offset 0,-0.6
    set xlabel trajectory eq "linear" ? "vertices of each" : ""
    set ylabel i == 1 ? "ns per query" : ""
    set format y i == 1 ? "10^{%L}" : ""
    plot for [k = 1:8] report."/times.dat" index kind." ".trajectory using 1:(column(k + 1)) with linespoints \
      pt 7 ps 0.5 lw (k == 2 ? 3.2 : 1.8) lc rgb color[k]
  }
}
# The legend is a plot of its own, all of whose points are out of range.
set margins at screen 0.05, screen 0.99, screen 0.01, screen 0.09
unset title; unset border; unset tics; unset grid; unset xlabel; unset ylabel
set key center center horizontal maxcols 4 maxrows 2 Left reverse samplen 2 width 1
plot for [k = 1:8] 1 with linespoints pt 7 ps 0.5 lw (k == 2 ? 3.2 : 1.8) lc rgb color[k] title label[k]
unset multiplot

# figure12.svg: the paper's Figure 12 as numbers and colours, one panel a method.
reset
set encoding utf8
set terminal svg size 1500,920 font "sans-serif,12" background "white"
set output report."/figure12.svg"
set logscale cb
set cbrange [20:2e5]
set format cb "10^{%L}"
set cblabel "ns per query"
set palette defined (0 "#f0f9e8", 1 "#bae4bc", 2 "#7bccc4", 3 "#43a2ca", 4 "#0868ac")
set xrange [2.5:10.5]
set yrange [2.5:10.5]
do for [power = 3:10] {
  set xtics add (sprintf("%d", 2**power) power) nomirror scale 0
  set ytics add (sprintf("%d", 2**power) power) nomirror scale 0
}
unset key
unset colorbox
log2(x) = log(x) / log(2)
short(ns) = ns < 1e4 ? sprintf("%.0f", ns) : sprintf("%.0fk", ns / 1e3)
set multiplot layout 2,3 margins 0.05,0.9,0.07,0.9 spacing 0.045,0.12 \
  title "Contours on the circular trajectory (the paper's Figure 12): ns per query" font ",17"
do for [i = 1:6] {
  k = int(word("2 1 3 4 5 7", i))
  set title label[k] offset 0,-0.5
  set xlabel i > 3 ? "vertices of the fixed polygon" : ""
  set ylabel i % 3 == 1 ? "vertices of the moving polygon" : ""
  if (i == 6) { set colorbox user origin screen 0.925, screen 0.2 size screen 0.015, screen 0.55 }
  plot report."/grid.dat" using (log2($1)):(log2($2)):(column(k + 2)) with image pixels, \
    '' using (log2($1)):(log2($2)):(short(column(k + 2))):(column(k + 2) > 2e3 ? 0xffffff : 0x111111) \
      with labels font ",11" tc rgb variable
}
unset multiplot
