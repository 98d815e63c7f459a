using Nowpose.Cli.Figures.Clocks;
using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Field;

/// <summary>Figs 4 and 8: what latency costs, and how well it is known.</summary>
sealed class ClockAndFieldStudy(FigureSettings settings) : IFigureStudy
{
    readonly ErrorField _field = new(settings);
    readonly ClockRuns _clocks = new(settings);

    public IReadOnlyList<Action> Work => [.. _field.Work, .. _clocks.Work];

    public IEnumerable<Figure> Figures() => [Figure04.Of(_field, _clocks), Figure08.Of(_clocks)];
}
