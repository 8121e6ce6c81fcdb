# Frame time along the walk by every method, on a logarithmic scale.
set terminal svg size 900,560 dynamic font 'sans-serif,13' background 'white' linewidth 1
set xlabel 'frame'
set ylabel 'frame time [ms], logarithmic'
set logscale y
set autoscale yfix
set ytics add ('1' 1, '2' 2, '5' 5, '10' 10, '20' 20, '50' 50, '100' 100, '200' 200)
plot for [m in methods] data using (only(m)):(measured('frametime_ms')) with lines lw 1.1 lc rgb color(m) title m
