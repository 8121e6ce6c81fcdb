# The share of samples in each layer of the layered depth images: the paper's Figure 5.
set style data histograms
set style histogram clustered gap 1
set style fill solid 0.9 noborder
set boxwidth 0.9
set ylabel 'share of the samples [%]'
set xlabel 'layer'
set yrange [0:100]
set grid noxtics
array colors[6] = [0x444444, 0x0072b2, 0x56b4e9, 0xd55e00, 0xe69f00, 0x009e73]
plot for [i=2:columns] data using i:xtic(1) lc rgb colors[(i-2)%6+1] title columnheader(i)
