# Draws tradeoff.svg, values.svg, accuracy.svg, extremes.svg and value_extremes.svg from tradeoff.dat, values.dat, accuracy.dat and extremes.dat in the directory `report`.
array family[14] = ["bounding discs", "influence areas", "tricover, tolerance", "tricover, plain float", \
  "tricover, plain double", "tricover, exact", "FCL MPR (libccd)", "FCL GJK (libccd)", "FCL GJK (indep)", "FCL BVH", \
  "GEOS", "Boost.Geometry", "Box2D overlap", "Box2D manifold"]
array color[14] = ["#94a3b8", "#64748b", "#38bdf8", "#818cf8", "#6366f1", "#1d4ed8", "#dc2626", "#f97316", "#a855f7", \
  "#374151", "#0f9d58", "#14b8a6", "#ca8a04", "#eab308"]
array shape[14] = [6, 4, 7, 12, 8, 7, 5, 9, 11, 13, 15, 14, 1, 2]
array size[14] = [0.9, 0.8, 0.5, 0.9, 0.9, 1.4, 0.5, 0.6, 0.6, 0.9, 0.8, 0.9, 0.9, 0.9]
many = system("sed -n 's/^# not convex, \\([0-9]*\\) .*/\\1/p' '".report."/tradeoff.dat' | head -n 1")
array group[4] = ["convex, 8 vertices", "convex, ".many." vertices", "not convex, ".many." vertices", "countries"]
set encoding utf8
set border lc rgb "#6b7280"

# tradeoff.svg: time against wrong answers, and time against tolerance.
set terminal svg size 1500,980 font "sans-serif,13" background "white"
set output report."/tradeoff.svg"
none = 4e-4  # where no wrong answer is drawn
has(g, f) = int(system(sprintf("grep -c '^# %s: %s$' '%s/tradeoff.dat' || true", group[g], family[f], report)))
set logscale xy
set grid xtics ytics lt 1 lc rgb "#e5e7eb" lw 1
set tics nomirror
unset key
set multiplot layout 2,4 margins 0.06,0.99,0.2,0.91 spacing 0.03,0.12 \
  title "Queries around first contact: what a wrong answer saves (down and to the left is better)" font ",17"
set xrange [2:8e3]
set yrange [none / 2:1]
set ytics ("none" none, "0.1 %%" 1e-3, "1 %%" 1e-2, "10 %%" 1e-1, "100 %%" 1)
do for [g = 1:4] {
  set title group[g] offset 0,-0.6
  set xlabel "ns per query"
  set ylabel g == 1 ? "wrong answers" : ""
  set format y g == 1 ? "%h" : ""
  if (g > 1) { set ytics ("" none, "" 1e-3, "" 1e-2, "" 1e-1, "" 1) }
  shown = ""
  do for [f = 1:14] { if (has(g, f)) { shown = shown." ".f } }
  plot for [f in shown] report."/tradeoff.dat" index group[g].": ".family[int(f)] \
    using 2:($3 > 0 ? $3 : none) with linespoints pt shape[int(f)] ps size[int(f)] lw 1.2 lc rgb color[int(f)]
}
set xrange [1e-12:1e-1]
set xtics ("10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10)
set yrange [20:8e3]
set ytics autofreq
set format y "10^{%L}"
do for [g = 1:4] {
  set title group[g] offset 0,-0.6
  set xlabel "tolerance"
  set ylabel g == 1 ? "ns per query" : ""
  if (g > 1) { set format y "" }
  shown = "3"
  do for [f = 7:9] { if (has(g, f)) { shown = shown." ".f } }
  plot for [f in shown] report."/tradeoff.dat" index group[g].": ".family[int(f)] \
      using 1:2 with linespoints pt shape[int(f)] ps size[int(f)] lw 2 lc rgb color[int(f)], \
    for [f in "5 6"] report."/tradeoff.dat" index group[g].": ".family[int(f)] \
      using (1e-1):2:(1e-12 - 1e-1):(0) with vectors nohead lw 2 lc rgb color[int(f)]
}
# The legend is a plot of its own, all of whose points are out of range.
set margins at screen 0.05, screen 0.99, screen 0.01, screen 0.12
unset title; unset border; unset tics; unset grid; unset xlabel; unset ylabel
unset logscale; set xrange [0:1]; set yrange [0:1]
set key center center horizontal maxcols 7 maxrows 2 Left reverse samplen 2 width 1
plot for [f = 1:14] 2 with linespoints pt shape[f] ps size[f] lw 1.6 lc rgb color[f] title family[f]
unset multiplot

# values.svg: time against the worst error of values.
reset
set encoding utf8
set border lc rgb "#6b7280"
set terminal svg size 1500,1400 font "sans-serif,13" background "white"
set output report."/values.svg"
array who[13] = ["tricover", "deepest of contacts()", "collide() at samples", "FCL GJK (libccd)", "FCL GJK (indep)", \
  "FCL BVH (RSS)", "FCL advancement (RSS)", "FCL EPA (indep)", "FCL MPR (libccd)", "GEOS", "Boost.Geometry", \
  "Box2D (float)", "Box2D manifold (float)"]
array paint[13] = ["#1d4ed8", "#38bdf8", "#818cf8", "#f97316", "#a855f7", "#374151", "#374151", "#a855f7", "#dc2626", \
  "#0f9d58", "#14b8a6", "#ca8a04", "#ca8a04"]
array mark[13] = [7, 6, 12, 9, 11, 13, 13, 11, 5, 15, 14, 1, 2]
array panel[12] = ["distance | convex, 8 vertices, gaps of 1e-13 to 1e-1 of the size", "distance | convex, 8 vertices, far apart", \
  "distance | irregular, 32 vertices, gaps of 1e-13 to 1e-1 of the size", "distance | irregular, 32 vertices, far apart", \
  "time of impact | convex, 8 vertices, sliding", "time of impact | convex, 8 vertices, turning", \
  "time of impact | irregular, 32 vertices, sliding", "time of impact | irregular, 32 vertices, turning", \
  "contacts | convex, 8 vertices", "contacts | convex, 32 vertices", \
  "penetration | convex, 8 vertices", "penetration | irregular, 32 vertices"]
least = 1e-16  # where no error is drawn
in(k, f) = int(system(sprintf("grep -cxF '# %s | %s' '%s/values.dat' || true", panel[k], who[f], report)))
set logscale xy
set grid xtics ytics lt 1 lc rgb "#e5e7eb" lw 1
set tics nomirror
unset key
set multiplot layout 3,4 margins 0.06,0.99,0.14,0.935 spacing 0.03,0.085 \
  title "Queries answered by numbers: time against the worst error (down and to the left is better)" font ",17"
set yrange [least / 3:3]
set xrange [50:1e6]
set format x "10^{%L}"
set ytics ("none" least, "10^{-12}" 1e-12, "10^{-9}" 1e-9, "10^{-6}" 1e-6, "10^{-3}" 1e-3, "1" 1)
set xlabel "ns per query"
do for [k = 1:12] {
  set title panel[k] noenhanced offset 0,-0.6 font ",11"
  set ylabel k % 4 == 1 ? "worst error: relative, in time, or of the size" : ""
  shown = ""
  do for [f = 1:13] { if (in(k, f)) { shown = shown." ".f } }
  plot for [f in shown] report."/values.dat" index panel[k]." | ".who[int(f)] \
    using 1:($2 > least ? $2 : least) with linespoints pt mark[int(f)] ps 0.9 lw 1.2 lc rgb paint[int(f)]
}
set margins at screen 0.05, screen 0.99, screen 0.005, screen 0.09
unset title; unset border; unset tics; unset grid; unset xlabel; unset ylabel
unset logscale; set xrange [0:1]; set yrange [0:1]
set key center center horizontal maxcols 5 maxrows 3 Left reverse samplen 2 width 1
plot for [f = 1:13] 2 with linespoints pt mark[f] ps 0.9 lw 1.6 lc rgb paint[f] title who[f]
unset multiplot

# accuracy.svg and extremes.svg: shares of wrong answers as colours.
reset
set encoding utf8
set palette defined (0 "#dcfce7", 0.001 "#fef3c7", 0.1 "#fdba74", 0.5 "#ef4444", 1 "#7f1d1d")
set cbrange [0:1]
unset colorbox
unset key
set border 0
set tics scale 0
set yrange [] reverse
percent(share) = share == 0 ? "" : share < 0.1 ? sprintf("%.1f", 100 * share) : sprintf("%.0f", 100 * share)
bold(name) = name eq "tricover, exact" ? "{/:Bold ".name."}" : name
ink(share) = share > 0.4 ? 0xffffff : 0x374151

set terminal svg size 1500,1050 font "sans-serif,11" background "white"
set output report."/accuracy.svg"
set title "Wrong answers (%) by the way from first contact, as a part of the size; left: penetrating (0 is best, and empty)" font ",16"
set xtics rotate by 50 right
plot report."/accuracy.dat" using 1:2:5:xtic(4):ytic(bold(strcol(3))) with image pixels, \
  '' using 1:2:(percent($5)):(ink($5)) with labels font ",9" tc rgb variable

set terminal svg size 1500,1100 font "sans-serif,11" background "white"
set output report."/extremes.svg"
set multiplot layout 2,2 margins 0.11,0.99,0.06,0.92 spacing 0.12,0.12 \
  title "Not right (%) at the extremes: wrong answers, exceptions, crashes (0 is best, and empty)" font ",16"
do for [sweep = 0:3] {
  set title word("'vertices moved by' 'poses moved by' 'scaled by' 'slivers, squeezed to'", sweep + 1) font ",14"
  block = "collide ".sweep
  plot report."/extremes.dat" index block using 1:2:6:xtic(4):ytic(bold(strcol(3))) with image pixels, \
    '' index block using 1:2:(percent($6)):(ink($6)) with labels font ",8" tc rgb variable
}
unset multiplot

# value_extremes.svg: worst errors as colours; one row a query.
set terminal svg size 1500,1130 font "sans-serif,11" background "white"
set output report."/value_extremes.svg"
set palette defined (0 "#dcfce7", 0.25 "#bbf7d0", 0.5 "#fef3c7", 0.8 "#fdba74", 1 "#ef4444")
set cbrange [-16:0]
array query[4] = ["distance", "time of impact", "contacts", "penetration"]
array rows[4] = [9, 5, 4, 4]
array off[4] = ["relative to the truth", "part of the motion", "relative to the size", "relative to the truth"]
label(power, faults) = sprintf("%d", floor(power + 0.5)).(faults > 0 ? " !" : "")
set multiplot title "Worst errors at the extremes, as powers of ten (-16 is best); !: wrong answers, exceptions, crashes" font ",16"
top = 0.925
do for [q = 1:4] {
  bottom = top - 0.0292 * rows[q]
  do for [sweep = 0:3] {
    set lmargin at screen 0.115 + 0.2225 * sweep
    set rmargin at screen 0.325 + 0.2225 * sweep
    set tmargin at screen top
    set bmargin at screen bottom
    set yrange [rows[q] - 0.5:-0.5]
    set title query[q].", ".word("'vertices moved by' 'poses moved by' 'scaled by' 'slivers, squeezed to'", sweep + 1) \
      offset 0,-0.6 font ",12"
    set format y sweep == 0 ? "%h" : ""
    set ytics noenhanced
    block = query[q]." ".sweep
    if (sweep == 0) {
      plot report."/extremes.dat" index block using 1:2:5:xtic(4):ytic(3) with image pixels, \
        '' index block using 1:2:(label($5, $6)):(ink($5 > -1 ? 1 : 0)) with labels font ",9" tc rgb variable
    } else {
      set ytics ("" 0)
      plot report."/extremes.dat" index block using 1:2:5:xtic(4) with image pixels, \
        '' index block using 1:2:(label($5, $6)):(ink($5 > -1 ? 1 : 0)) with labels font ",9" tc rgb variable
      set ytics autofreq
    }
  }
  top = bottom - 0.082
}
unset multiplot
