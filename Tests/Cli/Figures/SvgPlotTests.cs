using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Figures.Pictures;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Figures;

public class SvgPlotTests
{
    [TestCase(false, @"<path d=""M\S+ \S+L\S+ \S+M\S+ \S+L\S+ \S+""")]
    [TestCase(true, @"<path d=""M\S+ \S+H\S+L\S+ \S+M\S+ \S+H\S+L\S+ \S+""")]
    public void Draw_LineWithAMissingValue_LeavesAGap(bool isStepped, string path)
    {
        var trace = new PlotTrace("gap", "hold", [0, 1, 2, 3, 4], [1, 2, null, 2, 1]) { Stepped = isStepped };

        var svg = new SvgPlot(new FigurePlot("Gap", new FigureColumn("time", "s"), new FigureColumn("error", "mm"), [trace]), 400).Draw();

        Assert.That(svg, Does.Match(path));
    }
}
