# Draws times.svg, distance.svg, impact.svg, figure12.svg and speedup.svg from the .dat files that plot_data.cpp wrote to the
# directory `report`, and first.svg from first.csv there.
set encoding utf8
kinds = "convex slim starred contour irregular 'with hole'"
workloads = "circular linear 'gap 0.1' 'gap 0.01' contact near overlap"
titles = "'circular, gap 9' 'linear, into contact' 'circular, gap 0.1' 'circular, gap 0.01' contact near overlap"

# times.svg, distance.svg, impact.svg: polygons of equally many vertices, one panel a kind and workload.
array file[3] = ["times", "distance", "impact"]
array asked[3] = ["Collisions", "Distances", "Times of impact"]
array walks[3] = [workloads, "circular linear 'gap 0.01' near far overlap", "sliding turning"]
array heads[3] = [titles, "'circular, gap 9' 'linear, into contact' 'circular, gap 0.01' near 'far apart' overlapping", \
  "sliding 'sliding and turning'"]
array least[3] = [5, 20, 300]
array most[3] = [1e6, 3e6, 3e7]
array label[8] = ["tricover, cold", "tricover, cache", "tricover in FCL", "FCL GJK or MPR on convex pieces", \
  "FCL BVH of triangles", "GEOS, prepared or not", "Boost.Geometry", ""]
array last[3] = ["the paper's algorithm", "Box2D, cold or warm", "Box2D"]
array legend[3] = ["1 2 3 4 5 6 7 8", "1 2 3 4 5 6 7 8", "1 3 5 8"]
array color[8] = ["#7dd3fc", "#1d4ed8", "#0f9d58", "#dc2626", "#374151", "#a855f7", "#db7093", "#f59e0b"]
# Which of the methods answered: caches where steps are small, solvers for convex polygons and Box2D on those.
shown(f, w, k) = f == 3 ? "1 3 5".(k <= 2 ? " 8" : "") : \
  f == 2 ? "1 3 5 6 7".(w <= 3 ? " 2" : "").(k <= 2 ? " 4 8" : "") : \
  "1 3 4 5 6 7".(w <= 4 ? " 2" : "").(w <= 2 ? " 8" : "")
set border lc rgb "#6b7280"
set logscale x 2
set logscale y
set xtics (8, 32, 128, 512)
set tics nomirror
set datafile missing "inf"
unset key
do for [f = 1:3] {
  n = words(walks[f])
  height = 174 + 225 * n
  set terminal svg size 1500,height font "sans-serif,13" background "white"
  set output report."/".file[f].".svg"
  set multiplot layout n,6 margins 0.055,0.99,131. / height,1 - 85. / height spacing 0.012,52. / height \
    title asked[f].": time per query over the vertices of each of the two polygons (lower is better)" font ",17"
  set xrange [6:1400]
  set yrange [least[f]:most[f]]
  set border 31 lc rgb "#6b7280"; set grid xtics ytics lt 1 lc rgb "#e5e7eb" lw 1
  set xtics (8, 32, 128, 512) nomirror; set ytics autofreq nomirror
  unset key
  do for [w = 1:n] {
    do for [k = 1:6] {
      set title word(kinds, k).", ".word(heads[f], w) offset 0,-0.7
      set xlabel w == n ? "vertices of each" : "" offset 0,0.5
      set ylabel k == 1 ? "ns per query" : "" offset 1,0
      set format y k == 1 ? "10^{%L}" : ""
      set format x w == n ? "%.0f" : ""
      plot for [m in shown(f, w, k)] report."/".file[f].".dat" index word(kinds, k)." ".word(walks[f], w) \
        using 1:(column(m + 1)) with linespoints pt 7 ps 0.4 lw (m < 4 ? 2.6 : 1.6) lc rgb color[int(m)]
    }
  }
  # The legend is a plot of its own, all of whose points are out of range.
  set margins at screen 0.05, screen 0.99, screen 9. / height, screen 70. / height
  unset title; unset border; unset tics; unset grid; unset xlabel; unset ylabel
  set key center center horizontal maxcols 4 maxrows 2 Left reverse samplen 2 width 1
  plot for [m in legend[f]] least[f] / 2. with linespoints pt 7 ps 0.5 lw (m < 4 ? 2.6 : 1.6) lc rgb color[int(m)] \
    title m < 8 ? label[int(m)] : last[f]
  unset multiplot
  set margins
}

# figure12.svg: the paper's Figure 12, ours and the best rival's.
reset
set encoding utf8
set terminal svg size 1400,600 font "sans-serif,13" background "white"
set output report."/figure12.svg"
set palette defined (0 "#f0f9e8", 1 "#bae4bc", 2 "#7bccc4", 3 "#43a2ca", 4 "#0868ac")
set logscale z
set logscale cb
set zrange [5:1e4]
set cbrange [10:2e4]
set format z "10^{%L}"
set xrange [3:10]
set yrange [3:10]
set for [power = 3:10] xtics add (sprintf("%d", 2**power) power) offset -0.5,-0.4
set for [power = 3:10] ytics add (sprintf("%d", 2**power) power) offset 0.8,-0.3
set ztics offset 0.5,0
set xlabel "fixed"
set ylabel "moving"
set zlabel "ns per query" rotate by 90 offset 1,0
set grid x y z lt 1 lc rgb "#e5e7eb"
set xyplane at 5
set view 60,312,0.95,1.1
unset key
unset colorbox
set pm3d border lc rgb "#33556677" lw 0.6
log2(x) = log(x) / log(2)
array surface[2] = ["tricover, PairCache", "the best rival of each cell"]
set multiplot layout 1,2 \
  title "Contours on the circular trajectory (the paper's Figure 12), over the vertices of both polygons; lower is better" font ",17"
do for [i = 1:2] {
  set title surface[i] offset 0,-1 font ",15"
  splot report."/grid.dat" index "contour circular" using (log2($1)):(log2($2)):(column(i + 2)) with pm3d
}
unset multiplot

# speedup.svg: the best rival's time over ours on the vertex grid, one panel a kind and workload.
reset
set encoding utf8
set terminal svg size 1500,1750 font "sans-serif,12" background "white"
set output report."/speedup.svg"
set logscale cb
set cbrange [0.5:200]
set cbtics (0.5, 1, 2, 5, 10, 20, 50, 100, 200)
set cblabel "times as fast as the best rival"
set palette defined (0 "#b91c1c", 0.115 "#fca5a5", 0.117 "#fffbeb", 0.385 "#fde68a", \
  0.5 "#bbf7d0", 0.75 "#34d399", 1 "#065f46")
set xrange [2.5:10.5]
set yrange [2.5:10.5]
set tics scale 0 nomirror
unset key
log2(x) = log(x) / log(2)
short(ratio) = ratio < 10 ? sprintf("%.1f", ratio) : sprintf("%.0f", ratio)
set multiplot layout 7,6 margins 0.05,0.92,0.04,0.955 spacing 0.015,0.028 \
  title "Speed-up: the best rival's time over tricover's (PairCache on trajectories, none elsewhere); higher is better" font ",17"
do for [w = 1:7] {
  do for [k = 1:6] {
    set title word(kinds, k).", ".word(titles, w) offset 0,-0.8
    set xlabel w == 7 ? "fixed" : "" offset 0,0.5
    set ylabel k == 1 ? "moving" : "" offset 1.5,0
    unset xtics
    unset ytics
    if (w == 7) { set for [power = 3:10] xtics add (sprintf("%d", 2**power) power) scale 0 font ",9" }
    if (k == 1) { set for [power = 3:10] ytics add (sprintf("%d", 2**power) power) scale 0 font ",9" }
    unset colorbox
    if (w == 1 && k == 6) { set colorbox user origin screen 0.935, screen 0.3 size screen 0.012, screen 0.4 }
    plot report."/grid.dat" index word(kinds, k)." ".word(workloads, w) using (log2($1)):(log2($2)):(0.5):(0.5):5 \
        with boxxyerror fill solid noborder lc palette, \
      '' index word(kinds, k)." ".word(workloads, w) using \
        (log2($1)):(log2($2)):(short($5)):($5 < 0.8 || $5 > 80 ? 0xffffff : 0x111827) \
        with labels font ",8" tc rgb variable
  }
}
unset multiplot

# first.svg: the rows of first.csv that are near each other, a panel a polygon: time until the k-th answer.
reset
set encoding utf8
set terminal svg size 1500,700 font "sans-serif,12" background "white"
set output report."/first.svg"
set border lc rgb "#6b7280"
set datafile separator ","
array polygon[7] = ["outline,4", "outline,8", "outline,24", "outline,64", "outline,1024", "convex,4", "convex,8"]
array method[5] = ["tricover", "Boost", "GEOS", "GEOS prepared", "Box2D"]
array paint[5] = ["#1d4ed8", "#db7093", "#a855f7", "#6d28d9", "#f59e0b"]
set logscale xy
set xrange [0.9:110]
set format y "10^{%L}"
set tics nomirror
set grid lt 1 lc rgb "#e5e7eb" lw 1
set multiplot layout 2,4 margins 0.05,0.99,0.08,0.9 spacing 0.035,0.14 \
  title "Time until the k-th answer, from raw vertices on (lower is better; dotted: the same for every answer)" font ",17"
do for [p = 1:7] {
  comma = strstrt(polygon[p], ",")
  set title polygon[p][1:comma - 1].", ".polygon[p][comma + 1:*]." vertices" offset 0,-0.6
  set xlabel "k" offset 0,0.5
  set ylabel p % 4 == 1 ? "ns" : "" offset 1,0
  unset key
  if (p == 7) { set key at graph 1.2,0.95 left top Left reverse samplen 2 font ",13" }
  plot 100 * x with lines dt 3 lc rgb "#6b7280" notitle, \
    for [m = 1:(p > 5 ? 5 : 4)] "< grep '^first,".polygon[p][1:comma - 1].",near.*,".polygon[p][comma + 1:*].",".polygon[p][comma + 1:*].",.*\"".method[m]."\"' '".report."/first.csv'" \
      using 6:($6 * $10) with linespoints pt 7 ps 0.5 lw (m == 1 ? 2.6 : 1.6) lc rgb paint[m] title method[m]
}
unset multiplot
