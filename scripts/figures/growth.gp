# Median frame time as the triangles behind the portals grow.
set xlabel 'triangles of the building, logarithmic'
set ylabel 'median frame time [ms], logarithmic'
set logscale xy
set yrange [1:*]
set xrange [8e4:1.3e7]
set format x "%.0s%c"
set ytics add ('1' 1, '2' 2, '5' 5, '10' 10, '20' 20, '50' 50, '100' 100, '200' 200, '500' 500)
plot for [m in methods] data using 'triangles':m with linespoints lw 2 pt 7 ps 0.7 lc rgb color(m) title m
