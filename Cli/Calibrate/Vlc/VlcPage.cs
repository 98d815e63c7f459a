using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Creates the page section with L_visu of each picture, for measurements without a known load.</summary>
static class VlcPage
{
    public static CalibrationSection OverPictures(VlcResult result)
    {
        double[] places = [.. Enumerable.Range(1, result.Pictures.Count).Where(i => result.Pictures[i - 1].IsRead).Select(i => (double)i)];
        var trace = new PlotTrace("L_visu", Looks.Adaptive, places, [.. result.Read.Select(picture => (double?)picture.VisuMs)]) { Scattered = true };
        return new("L_visu from picture to picture", "Fig. 10",
            "A picture is taken at a random moment while a frame is lit. L_visu therefore scatters by half of that time to either side; the result is its mean.",
            [new FigurePlot("Over pictures", new("picture"), new("L_visu", "ms"), [trace]) { FromZero = true }]);
    }
}
