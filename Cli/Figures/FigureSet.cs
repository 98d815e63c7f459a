using Nowpose.Cli.Figures.Display;
using Nowpose.Cli.Figures.Field;
using Nowpose.Cli.Figures.Sweeps;
using Nowpose.Cli.Figures.Swing;

namespace Nowpose.Cli.Figures;

/// <summary>All figures of the paper that can be computed.</summary>
static class FigureSet
{
    /// <summary>The figure numbers in order. The sweeps add their letters.</summary>
    public static IReadOnlyList<string> Numbers { get; } =
        ["4", "8", "10", "11a", "11b", "12", "13a", "13b", "13c", "13d", "14a", "14b", "14c", "14d", "16", "17", "18"];

    /// <summary>Gets the studies, the short ones first, so that an interrupted run has a partial result.</summary>
    public static IReadOnlyList<IFigureStudy> Studies(FigureSettings settings) =>
        [new DisplayStudy(settings), new Figure12(settings), new SwingStudy(settings), new ClockAndFieldStudy(settings), .. SweepStudy.All(settings)];
}
