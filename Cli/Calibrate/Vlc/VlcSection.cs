using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Creates the page section with L_visu of each picture, for measurements without a known load.</summary>
static class VlcSection
{
    public static CalibrationSection OverPictures(VlcResult result)
    {
        double[] places = [.. Enumerable.Range(1, result.Pictures.Count).Where(i => result.Pictures[i - 1].IsRead).Select(i => (double)i)];
        var trace = new PlotTrace("L_visu", Looks.Adaptive, places, [.. result.Read.Select(picture => (double?)picture.VisuMs)]) { Scattered = true };
        return new(CalibrationPageTexts.OverPictures, "Fig. 10",
            CalibrationPageTexts.OverPicturesNote,
            [new FigurePlot("Over pictures", new("picture"), new("L_visu", "ms"), [trace]) { FromZero = true }]);
    }
}
