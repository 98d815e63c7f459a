using Nowpose.Cli.Figures.Display;
using Nowpose.Cli.Figures.Field;
using Nowpose.Cli.Figures.Sweeps;
using Nowpose.Cli.Figures.Swing;

namespace Nowpose.Cli.Figures;

/// <summary>Lists all figures of the paper that can be computed.</summary>
static class FigureSet
{
    /// <summary>Numbers of the figures in the paper's order. The sweeps have one letter per panel.</summary>
    public static IReadOnlyList<string> Numbers { get; } =
        ["4", "8", "10", "11a", "11b", "12", "13a", "13b", "13c", "13d", "14a", "14b", "14c", "14d", "16", "17", "18"];

    /// <summary>Creates the studies. Short studies come first, so that an interrupted run has a partial result.</summary>
    /// <param name="cancel">Cancels work items that take long.</param>
    public static IReadOnlyList<IFigureStudy> Studies(FigureSettings settings, CancellationToken cancel) =>
        [new DisplayStudy(settings), new Figure12(settings), new SwingRuns(settings, cancel), new ClockAndFieldStudy(settings), .. SweepStudy.All(settings)];
}
